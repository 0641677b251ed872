// SPDX-License-Identifier: MIT
// From where one looks at the machine, and where points of it appear. Angles are degrees; z is up.
import { add, cross, dot, scale, subtract } from './vectors.js';

export const FIELD = 28; // degrees from top to bottom
const RADIANS = Math.PI / 180;

export function createCamera(model) {
    const camera = { ...model.view, zoom: 1, width: 1, height: 1 };
    camera.reset = () => Object.assign(camera, model.view, { zoom: 1 });
    camera.turn = (right, up) => {
        camera.azimuth -= right;
        camera.elevation = Math.min(Math.max(camera.elevation + up, -89), 89);
    };
    camera.magnify = (by) => {
        camera.zoom = Math.min(Math.max(camera.zoom * by, 0.5), 12);
    };
    camera.lookAtPoint = (point) => {
        camera.azimuth = Math.atan2(point[1], point[0]) / RADIANS;
        camera.elevation = Math.asin(Math.min(Math.max(point[2] / Math.hypot(...point), -1), 1)) / RADIANS;
    };
    camera.axes = () => axes(camera, model);
    return camera;
}

function axes(camera, model) {
    const azimuth = camera.azimuth * RADIANS;
    const elevation = camera.elevation * RADIANS;
    const back = [Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation)];
    const up = [-Math.sin(elevation) * Math.cos(azimuth), -Math.sin(elevation) * Math.sin(azimuth), Math.cos(elevation)];
    const half = Math.sin((FIELD / 2) * RADIANS);
    const distance = (1.04 * model.radius) / half / Math.min(1, camera.width / camera.height);
    // Nearer by zoom, but not into the machine: what is left is a longer focal length.
    const eye = add(model.target, scale(back, distance));
    return { eye, back, up, right: cross(up, back), distance, focal: (camera.zoom * camera.height) / 2 / Math.tan((FIELD / 2) * RADIANS) };
}

// [x, y] of the drawing in its pixels, and the distance from the eye's plane.
export function projector(camera) {
    const { eye, back, up, right, focal } = camera.axes();
    return (point) => {
        const from = subtract(point, eye);
        const away = -dot(from, back);
        return [camera.width / 2 + (focal * dot(from, right)) / away, camera.height / 2 - (focal * dot(from, up)) / away, away];
    };
}
