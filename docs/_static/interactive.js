// The page on which one moves two ellipsoids. Orthographic view: an ellipsoid with the form Q is seen as the ellipse of the
// upper left block of VQVᵀ, with the rotation V of the view.
(async function () {
    "use strict";
    const START = {
        axes: [[3, 2, 1], [4, 1, 1]],
        quaternions: [[1, 0, 0, 0], [0.9, 0.1, 0.3, 0.2]],
        r12: [3, 2, 1],
        view: [0.83, -0.42, -0.33, -0.15],
        scale: 1,
    };
    const COLOURS = ["#0072b2", "#d55e00"];
    const DIGITS = 15;
    const element = id => document.getElementById("pair-" + id);
    const view = element("view"), curve = element("curve");

    const bytes = Uint8Array.from(atob(PW85_WASM), c => c.charCodeAt(0));
    const library = (await WebAssembly.instantiate(bytes, {})).instance.exports;
    const input = new Float64Array(library.memory.buffer, library.input.value, 17);
    const output = new Float64Array(library.memory.buffer, library.output.value, 129);
    let state, selected = 1;

    // Small vectors, row by row; quaternions are (w, x, y, z).
    const dot = (x, y) => x.reduce((sum, xi, i) => sum + xi * y[i], 0);
    const add = (x, y, factor = 1) => x.map((xi, i) => xi + factor * y[i]);
    const product = (matrix, x) => matrix.map(row => dot(row, x));
    const transposed = m => m[0].map((_, j) => m.map(row => row[j]));
    const unit = x => x.map(xi => xi / Math.sqrt(dot(x, x)));

    function multiply([a, b, c, d], [w, x, y, z]) {
        return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w];
    }

    function rotation(quaternion) {
        const [w, x, y, z] = unit(quaternion);
        return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]];
    }

    const turned = (quaternion, [x, y, z]) => unit(multiply([1, x / 2, y / 2, z / 2], quaternion));

    function evaluate() {
        input.set([...state.axes[0], ...state.quaternions[0], ...state.axes[1], ...state.quaternions[1], ...state.r12]);
        library.evaluate();
        const at = (start, count) => [...output.slice(start, start + count)];
        return {status: output[0], mu2: output[1], lambda: output[2], distance: output[3], point: at(4, 3), normal: at(7, 3),
            closest: [at(10, 3), at(13, 3)], forms: [at(16, 6), at(22, 6)], f: at(28, 101)};
    }

    // The state in the address, without the view.
    function toAddress() {
        const lists = [state.axes[0], state.quaternions[0], state.axes[1], state.quaternions[1], state.r12];
        return "#" + lists.map(list => list.map(x => +x.toFixed(4)).join(",")).join(";");
    }

    function fromAddress() {
        state = structuredClone(START);
        const lists = decodeURIComponent(location.hash.slice(1)).split(";").map(list => list.split(",").map(Number));
        const right = lists.length === 5 && lists.map(list => list.length).join() === "3,4,3,4,3";
        if (right && lists.flat().every(Number.isFinite)) {
            state.axes = [lists[0], lists[2]];
            state.quaternions = [lists[1], lists[3]];
            state.r12 = lists[4];
        }
    }

    function fitted(canvas, height) {
        const width = canvas.clientWidth, ratio = window.devicePixelRatio || 1;
        canvas.width = width * ratio;
        canvas.height = height * ratio;
        canvas.style.height = height + "px";
        const context = canvas.getContext("2d");
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        const style = getComputedStyle(document.body);
        context.strokeStyle = context.fillStyle = style.getPropertyValue("--color-foreground-primary") || "black";
        return [context, width, height];
    }

    // From space to pixels; the middle of both centres is in the middle of the canvas.
    function camera(width, height) {
        const matrix = rotation(state.view);
        const size = Math.max(...state.axes.flat()) + Math.sqrt(dot(state.r12, state.r12)) / 2;
        const factor = state.scale * 0.47 * Math.min(width, height) / Math.max(size, 1e-3);
        const middle = state.r12.map(x => x / 2);
        const toPixels = x => {
            const seen = product(matrix, add(x, middle, -1));
            return [width / 2 + factor * seen[0], height / 2 - factor * seen[1], seen[2]];
        };
        return {matrix, factor, toPixels};
    }

    // Half-axes and angle of the ellipse that is seen, in units of space.
    function seenEllipse([xx, xy, xz, yy, yz, zz], matrix) {
        const form = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        const block = [0, 1].map(i => [0, 1].map(j => dot(matrix[i], product(form, matrix[j]))));
        const [[a, b], [, c]] = block, mean = (a + c) / 2, spread = Math.hypot((a - c) / 2, b);
        return {long: Math.sqrt(mean + spread), short: Math.sqrt(Math.max(mean - spread, 0)), angle: Math.atan2(2 * b, a - c) / 2,
            block};
    }

    function drawEllipse(context, {toPixels, factor, matrix}, center, form, scale) {
        const [x, y] = toPixels(center), {long, short, angle} = seenEllipse(form, matrix);
        context.beginPath();
        context.ellipse(x, y, factor * scale * long, factor * scale * short, -angle, 0, 2 * Math.PI);
    }

    // The three ellipses in the principal planes, on the side that is seen.
    function drawSections(context, {toPixels, matrix}, center, axes, quaternion) {
        const directions = transposed(rotation(quaternion)).map((v, i) => v.map(x => x * axes[i]));
        for (let k = 0; k < 3; ++k) {
            const [u, v] = [directions[(k + 1) % 3], directions[(k + 2) % 3]];
            const normalTo = (s, t) => add(u.map(x => s * x / dot(u, u)), v, t / dot(v, v));
            context.beginPath();
            let drawing = false;
            for (let i = 0; i <= 96; ++i) {
                const s = Math.cos(i * Math.PI / 48), t = Math.sin(i * Math.PI / 48);
                const front = dot(matrix[2], normalTo(s, t)) >= 0;
                const [x, y] = toPixels(add(add(center, u, s), v, t));
                if (front) drawing ? context.lineTo(x, y) : context.moveTo(x, y);
                drawing = front;
            }
            context.stroke();
        }
    }

    function drawBody(context, seen, k, center, form, mu) {
        const [x, y] = seen.toPixels(center), {long} = seenEllipse(form, seen.matrix);
        drawEllipse(context, seen, center, form, 1);
        const light = context.createRadialGradient(x - 5, y - 10, 1, x, y, seen.factor * long);
        light.addColorStop(0, COLOURS[k] + "b0");
        light.addColorStop(1, COLOURS[k] + "f0");
        context.fillStyle = light;
        context.fill();
        context.strokeStyle = k === selected ? "#ffffff" : COLOURS[k];
        context.lineWidth = 0.8;
        drawSections(context, seen, center, state.axes[k], state.quaternions[k]);
        context.strokeStyle = COLOURS[k];
        context.lineWidth = 1.5;
        context.setLineDash([5, 4]);
        drawEllipse(context, seen, center, form, mu);
        context.stroke();
        context.setLineDash([]);
    }

    function drawLine(context, from, to) {
        context.beginPath();
        context.moveTo(from[0], from[1]);
        context.lineTo(to[0], to[1]);
        context.stroke();
    }

    function drawContact(context, {toPixels}, result, ink) {
        context.strokeStyle = context.fillStyle = ink;
        context.lineWidth = 1;
        if (result.distance > 0) drawLine(context, toPixels(result.closest[0]), toPixels(result.closest[1]));
        const size = Math.max(...state.axes.flat()) / 2, at = toPixels(result.point);
        context.lineWidth = 2;
        drawLine(context, at, toPixels(add(result.point, result.normal, size)));
        context.beginPath();
        context.arc(at[0], at[1], 4, 0, 2 * Math.PI);
        context.fill();
    }

    function drawView(result) {
        const [context, width, height] = fitted(view, Math.min(view.clientWidth * 0.62, 460));
        const seen = camera(width, height), ink = context.strokeStyle;
        const centers = [[0, 0, 0], state.r12];
        const order = seen.toPixels(centers[0])[2] < seen.toPixels(centers[1])[2] ? [0, 1] : [1, 0];
        for (const k of order) drawBody(context, seen, k, centers[k], result.forms[k], Math.sqrt(result.mu2));
        if (result.mu2 > 0) drawContact(context, seen, result, ink);
    }

    function drawCurve(result) {
        const [context, width, height] = fitted(curve, 150);
        const top = Math.max(1.2, 1.1 * result.mu2);
        const toPixels = (lambda, f) => [8 + lambda * (width - 16), height - 8 - f / top * (height - 16)];
        context.globalAlpha = 0.4;
        drawLine(context, toPixels(0, 1), toPixels(1, 1));
        drawLine(context, toPixels(0, 0), toPixels(1, 0));
        context.globalAlpha = 1;
        context.lineWidth = 2;
        context.beginPath();
        result.f.forEach((f, i) => context.lineTo(...toPixels(i / 100, f)));
        context.stroke();
        context.beginPath();
        context.arc(...toPixels(result.lambda, result.mu2), 5, 0, 2 * Math.PI);
        context.fill();
    }

    function show(result) {
        const good = result.status === 0, list = x => "(" + x.map(xi => xi.toFixed(6)).join(", ") + ")";
        element("mu2").textContent = good ? result.mu2.toPrecision(DIGITS) : "no ellipsoid";
        element("lambda").textContent = good ? result.lambda.toPrecision(DIGITS) : "";
        element("verdict").textContent = !good ? "" : result.mu2 < 1 ? "they overlap" : "they are apart";
        element("distance").textContent = good ? result.distance.toPrecision(DIGITS) : "";
        element("point").textContent = good ? list(result.point) : "";
        element("normal").textContent = good ? list(result.normal) : "";
    }

    function update() {
        const result = evaluate();
        show(result);
        if (result.status === 0) {
            drawView(result);
            drawCurve(result);
        }
        document.querySelectorAll("#pair-axes input").forEach((slider, i) => {
            slider.value = Math.log2(state.axes[Math.floor(i / 3)][i % 3]);
        });
    }

    function changed() {
        history.replaceState(null, "", toAddress());
        update();
    }

    // Motions in the view: right, up, towards the reader.
    const inSpace = x => product(transposed(rotation(state.view)), x);

    function move(k, x) {
        state.r12 = add(state.r12, inSpace(x), k === 1 ? 1 : -1);
    }

    function turn(k, x) {
        state.quaternions[k] = turned(state.quaternions[k], inSpace(x));
    }

    function hit(x, y) {
        const seen = camera(view.clientWidth, view.clientHeight), {forms} = evaluate(), centers = [[0, 0, 0], state.r12];
        const hits = [0, 1].filter(k => {
            const [cx, cy] = seen.toPixels(centers[k]), d = [(x - cx) / seen.factor, (cy - y) / seen.factor];
            const [[a, b], [, c]] = seenEllipse(forms[k], seen.matrix).block;
            return (c * d[0] * d[0] - 2 * b * d[0] * d[1] + a * d[1] * d[1]) / (a * c - b * b) <= 1;
        });
        hits.sort((i, j) => seen.toPixels(centers[j])[2] - seen.toPixels(centers[i])[2]);
        return hits.length ? hits[0] : -1;
    }

    function drag(k, dx, dy, turning) {
        const {factor} = camera(view.clientWidth, view.clientHeight);
        if (k < 0) state.view = turned(state.view, [dy / 120, dx / 120, 0]);
        else if (turning) turn(k, [dy / 80, dx / 80, 0]);
        else move(k, [dx / factor, -dy / factor, 0]);
        changed();
    }

    function listenToPointer() {
        let held = null;
        view.addEventListener("pointerdown", event => {
            const box = view.getBoundingClientRect();
            held = {k: hit(event.clientX - box.left, event.clientY - box.top), x: event.clientX, y: event.clientY};
            if (held.k >= 0) selected = held.k;
            view.setPointerCapture(event.pointerId);
            update();
        });
        view.addEventListener("pointermove", event => {
            if (!held) return;
            const turning = event.shiftKey || document.querySelector("#pair input[name=drag]:checked").value === "turn";
            drag(held.k, event.clientX - held.x, event.clientY - held.y, turning);
            held.x = event.clientX;
            held.y = event.clientY;
        });
        for (const end of ["pointerup", "pointercancel"]) view.addEventListener(end, () => { held = null; });
    }

    function listenToKeys() {
        const motions = {ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0],
            PageUp: [0, 0, 1], PageDown: [0, 0, -1]};
        view.addEventListener("keydown", event => {
            const motion = motions[event.key];
            if (event.key === "1" || event.key === "2") selected = Number(event.key) - 1;
            else if (!motion) return;
            else if (event.shiftKey) turn(selected, [-0.1 * motion[1], 0.1 * motion[0], 0.1 * motion[2]]);
            else move(selected, motion.map(x => 0.1 * x));
            event.preventDefault();
            changed();
        });
    }

    function listenToControls() {
        const zoom = factor => { state.scale *= factor; update(); };
        element("closer").addEventListener("click", () => zoom(1.2));
        element("farther").addEventListener("click", () => zoom(1 / 1.2));
        element("reset").addEventListener("click", () => { state = structuredClone(START); changed(); });
        for (let i = 0; i < 6; ++i) {
            const slider = document.createElement("input");
            Object.assign(slider, {type: "range", min: -5, max: 3, step: 0.05});
            slider.setAttribute("aria-label", `semi-axis ${i % 3 + 1} of ellipsoid ${Math.floor(i / 3) + 1}`);
            slider.style.accentColor = COLOURS[Math.floor(i / 3)];
            slider.addEventListener("input", () => {
                state.axes[Math.floor(i / 3)][i % 3] = 2 ** Number(slider.value);
                changed();
            });
            element("axes").append(slider);
        }
    }

    fromAddress();
    listenToPointer();
    listenToKeys();
    listenToControls();
    window.addEventListener("hashchange", () => { fromAddress(); update(); });
    window.addEventListener("resize", update);
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", update);
    update();
})();
