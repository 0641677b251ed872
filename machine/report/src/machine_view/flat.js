// SPDX-License-Identifier: MIT
// Draws the faces and lines on a canvas, the farthest first: where there is no WebGL, and on paper.
import { themeColour } from '../colour.js';
import { projector } from './camera.js';
import { lineStrength } from './shapes.js';

// Whether a face shows its front: on the screen y is downwards.
export function facesViewer(corners) {
    let area = 0;
    for (let i = 0; i < corners.length; ++i) {
        const [x, y] = corners[i];
        const [nextX, nextY] = corners[(i + 1) % corners.length];
        area += x * nextY - nextX * y;
    }
    return area < 0;
}

export function createFlat(canvas, model) {
    const { shapes, culls } = model;
    const context = canvas.getContext('2d');
    let colours = [];
    return {
        name: 'flat',
        colour(colourOf) {
            colours = shapes.faces.map((face) => `rgb(${colourOf(face).map(Math.round).join(',')})`);
        },
        draw(camera) {
            canvas.width = camera.width * devicePixelRatio;
            canvas.height = camera.height * devicePixelRatio;
            context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
            drawLines(context, shapes.lines, projector(camera));
            for (const { face, corners } of inOrder(shapes.faces, projector(camera), culls)) {
                fillPolygon(context, corners, colours[face]);
            }
        },
    };
}

function inOrder(faces, project, culls) {
    const seen = [];
    faces.forEach(({ points, layer }, face) => {
        const corners = points.map(project);
        if (!culls || facesViewer(corners)) {
            const away = corners.reduce((sum, corner) => sum + corner[2], 0) / corners.length;
            seen.push({ face, corners, layer, away });
        }
    });
    // On a sphere what is seen never hides each other but by layers.
    return seen.sort((a, b) => (culls ? a.layer - b.layer : b.away - a.away || a.layer - b.layer));
}

function fillPolygon(context, corners, colour) {
    context.beginPath();
    corners.forEach(([x, y]) => context.lineTo(x, y));
    context.closePath();
    context.fillStyle = colour;
    context.fill();
}

function drawLines(context, lines, project) {
    context.strokeStyle = themeColour('wire');
    context.globalAlpha = lineStrength(lines);
    context.beginPath();
    for (const [from, to] of lines) {
        context.moveTo(...project(from).slice(0, 2));
        context.lineTo(...project(to).slice(0, 2));
    }
    context.stroke();
    context.globalAlpha = 1;
}
