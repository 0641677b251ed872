// SPDX-License-Identifier: MIT
// Draws the faces and lines by three.js.
import {
    BufferAttribute, BufferGeometry, ColorManagement, DoubleSide, FrontSide, LinearSRGBColorSpace, LineBasicMaterial, LineSegments, Mesh,
    MeshBasicMaterial, PerspectiveCamera, Scene, WebGLRenderer,
} from 'three';
import { themeColour } from '../colour.js';
import { FIELD } from './camera.js';
import { lineStrength } from './shapes.js';

// Null where WebGL cannot be had; three.js itself would write errors to the console.
export function createWebgl(canvas, model) {
    const context = canvas.getContext('webgl2', { antialias: true, alpha: true });
    if (!context) {
        return null;
    }
    ColorManagement.enabled = false;
    const renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    renderer.outputColorSpace = LinearSRGBColorSpace;
    const scene = new Scene();
    const faces = faceMesh(model);
    const lines = lineMesh(model);
    scene.add(faces.mesh, lines);
    const eye = new PerspectiveCamera(FIELD, 1, 0.5, 50);
    return {
        name: 'webgl',
        colour: (colourOf) => faces.colour(colourOf),
        draw(camera) {
            place(eye, camera, model);
            lines.material.color.set(themeColour('wire'));
            renderer.setPixelRatio(devicePixelRatio);
            renderer.setSize(camera.width, camera.height, false);
            renderer.render(scene, eye);
        },
    };
}

function place(eye, camera, model) {
    const { eye: at, up, distance } = camera.axes();
    eye.position.set(...at);
    eye.up.set(...up);
    eye.lookAt(...model.target);
    eye.aspect = camera.width / camera.height;
    eye.zoom = camera.zoom * camera.fitted;
    eye.setViewOffset(camera.width, camera.height, camera.middle[0] * camera.zoom, camera.middle[1] * camera.zoom, camera.width, camera.height);
    eye.near = Math.max(distance - 2 * model.radius, 0.1);
    eye.far = distance + 2 * model.radius;
    eye.updateProjectionMatrix();
}

// Polygons as fans of triangles; every corner has its face's colour.
function faceMesh({ shapes, culls }) {
    const corners = shapes.faces.reduce((sum, face) => sum + face.points.length, 0);
    const positions = new Float32Array(3 * corners);
    const colours = new Uint8Array(3 * corners);
    const index = [];
    let first = 0;
    for (const { points } of shapes.faces) {
        points.forEach((point, i) => positions.set(point, 3 * (first + i)));
        for (let i = 2; i < points.length; ++i) {
            index.push(first, first + i - 1, first + i);
        }
        first += points.length;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('color', new BufferAttribute(colours, 3, true));
    geometry.setIndex(index);
    const mesh = new Mesh(geometry, new MeshBasicMaterial({ vertexColors: true, side: culls ? FrontSide : DoubleSide }));
    mesh.frustumCulled = false;
    return { mesh, colour: (colourOf) => paint(shapes, geometry.attributes.color, colourOf) };
}

function paint(shapes, attribute, colourOf) {
    let corner = 0;
    for (const face of shapes.faces) {
        const colour = colourOf(face);
        for (let i = 0; i < face.points.length; ++i) {
            attribute.array.set(colour, 3 * corner);
            ++corner;
        }
    }
    attribute.needsUpdate = true;
}

function lineMesh({ shapes }) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(shapes.lines.flat(2)), 3));
    const mesh = new LineSegments(geometry, new LineBasicMaterial({ transparent: true, opacity: lineStrength(shapes.lines) }));
    mesh.visible = shapes.lines.length > 0;
    mesh.frustumCulled = false;
    return mesh;
}
