// SPDX-License-Identifier: MIT
// What feeds processors and what they feed, in whatever way those are drawn: a tree above them whose
// top is the host, each part over the middle of what lies below it; in front and below what takes
// what they make.
import { addBox } from './shapes.js';
import { add, mean } from './vectors.js';

const HEIGHT = 1.5; // of the host above processors that are 2 wide
const BELOW = 0.3;
const BAR = [0.8, 0.03, 0.03]; // of what takes what processors make

// What each part hands on to.
function childrenOf(run) {
    const { parts, fed_by: fedBy } = run.drawing;
    const children = parts.map(() => ({ parts: [], nodes: [] }));
    parts.forEach((part, i) => {
        if (part.parent !== null && part.place === 'before') {
            children[part.parent].parts.push(i);
        }
    });
    fedBy.forEach((part, node) => {
        if (part !== null) {
            children[part].nodes.push(node);
        }
    });
    return children;
}

// Middle and size of what lies below each part, and how many levels there are.
function placeParts(children, cells) {
    const places = children.map(() => null);
    const place = (part) => {
        places[part] ??= combine(children[part].parts.map(place), children[part].nodes.map((node) => cells[node]));
        return places[part];
    };
    children.forEach((_, part) => place(part));
    return places;
}

function combine(parts, nodes) {
    const below = [...parts.map((part) => part.middle), ...nodes.map((node) => node.middle)];
    return {
        middle: below.length > 0 ? mean(below) : [0, 0, 0],
        area: [...parts, ...nodes].reduce((sum, each) => sum + each.area, 0),
        level: 1 + Math.max(0, ...parts.map((part) => part.level)),
    };
}

// One that hands on to many is a bar, as a bus is drawn. Of many parts each is small.
function boxSize(place, fanOut, parts) {
    const largest = 0.045 * Math.min(1, (24 / parts) ** 0.4);
    const side = Math.min(Math.max(0.11 * Math.sqrt(place.area), 0.008), largest);
    return fanOut > 2 ? [Math.max(0.4 * Math.sqrt(place.area), side), side / 2, side / 2] : [side, side, side];
}

// Where a wire leaves a box: from a bar as near to the other end as there is.
function tapOf([x, y, z], [half], to) {
    return [Math.min(Math.max(to[0], x - half), x + half), y, z];
}

// `cells`: the middle, area and lower edge of what stands for each processor.
export function addParts(shapes, run, cells) {
    const { parts } = run.drawing;
    const children = childrenOf(run);
    const places = placeParts(children, cells);
    const levels = Math.max(1, ...places.map((place) => place.level));
    const at = places.map(({ middle, level }) => [middle[0], middle[1], (HEIGHT * level) / levels]);
    parts.forEach(({ place }, part) => {
        if (place !== 'before') {
            return;
        }
        const size = boxSize(places[part], children[part].nodes.length, parts.length);
        addBox(shapes, 'part', part, at[part], size);
        children[part].parts.forEach((child) => shapes.addLine(at[part], at[child]));
        children[part].nodes.forEach((node) => shapes.addLine(tapOf(at[part], size, cells[node].middle), cells[node].middle));
    });
    parts.forEach(({ place, parent }, part) => {
        if (place === 'beside') {
            const size = boxSize(places[parent], children[parent].nodes.length, parts.length);
            const position = add(at[parent], [0, 0, -0.3 * at[parent][2]]);
            addBox(shapes, 'part', part, position, size);
            shapes.addLine(position, at[parent]);
        } else if (place === 'behind') {
            const front = Math.min(...cells.map((cell) => cell.bottom)) - BELOW;
            addBox(shapes, 'part', part, [0, front, -BELOW], BAR);
            cells.forEach((cell) => shapes.addLine(cell.middle, tapOf([0, front, -BELOW], BAR, cell.middle)));
        }
    });
}
