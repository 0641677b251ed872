// SPDX-License-Identifier: MIT
// From where one looks at the machine, and where points of it appear. Angles are degrees; z is up.
import { add, cross, dot, scale, subtract } from './vectors.js';

export const FIELD = 28; // degrees from top to bottom
const FILLED = 0.94; // of the drawing
const RADIANS = Math.PI / 180;

export function createCamera(model) {
    const camera = { ...model.view, zoom: 1, width: 1, height: 1, fitted: 1, middle: [0, 0] };
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
    camera.resize = (width, height) => {
        if (width !== camera.width || height !== camera.height) {
            Object.assign(camera, { width, height }, fit({ ...camera, ...model.view, zoom: 1, width, height }, model));
        }
    };
    return camera;
}

// How much larger, and where its middle is put, so that the machine fills the drawing as it is first seen.
function fit(camera, model) {
    const project = projector({ ...camera, fitted: 1, middle: [0, 0], axes: () => axes({ ...camera, fitted: 1 }, model) });
    let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
    for (const { points } of model.shapes.faces) {
        for (const [x, y] of points.map(project)) {
            [left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x), Math.max(bottom, y)];
        }
    }
    const fitted = Math.min((camera.width * FILLED) / (right - left || 1), (camera.height * FILLED) / (bottom - top || 1));
    return { fitted, middle: [((left + right - camera.width) / 2) * fitted, ((top + bottom - camera.height) / 2) * fitted] };
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
    return { eye, back, up, right: cross(up, back), distance, focal: (camera.zoom * camera.fitted * camera.height) / 2 / Math.tan((FIELD / 2) * RADIANS) };
}

// [x, y] of the drawing in its pixels, and the distance from the eye's plane.
export function projector(camera) {
    const { eye, back, up, right, focal } = camera.axes();
    return (point) => {
        const from = subtract(point, eye);
        const away = -dot(from, back);
        const [x, y] = camera.middle.map((middle) => middle * camera.zoom);
        return [camera.width / 2 - x + (focal * dot(from, right)) / away, camera.height / 2 - y - (focal * dot(from, up)) / away, away];
    };
}
