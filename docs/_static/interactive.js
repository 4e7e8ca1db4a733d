// The page on which one moves two ellipsoids: its state, its controls, and its numbers, which the library computes.
// interactive_scene.js draws them.
(async function () {
    "use strict";
    const START = {
        axes: [[3, 2, 1], [4, 1, 1]],
        quaternions: [[1, 0, 0, 0], [0.9, 0.1, 0.3, 0.2]], // w, x, y, z
        r12: [3, 2, 1],
        view: [0.83, -0.42, -0.33, -0.15],
        scale: 1.4,
    };
    const COLOURS = ["#0072b2", "#d55e00"];
    const DIGITS = 15;
    const element = id => document.getElementById("pair-" + id);
    const view = element("view"), curve = element("curve");

    const bytes = Uint8Array.from(atob(PW85_WASM), c => c.charCodeAt(0));
    const library = (await WebAssembly.instantiate(bytes, {})).instance.exports;
    const input = new Float64Array(library.memory.buffer, library.input.value, 17);
    const output = new Float64Array(library.memory.buffer, library.output.value, 117);
    const scene = makeScene(view.querySelector("canvas"), COLOURS);
    let state, selected = 1;

    function evaluate() {
        input.set([...state.axes[0], ...state.quaternions[0], ...state.axes[1], ...state.quaternions[1], ...state.r12]);
        library.evaluate();
        const at = (start, count) => [...output.slice(start, start + count)];
        return {status: output[0], mu2: output[1], lambda: output[2], distance: output[3], point: at(4, 3), normal: at(7, 3),
            closest: [at(10, 3), at(13, 3)], f: at(16, 101)};
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

    function drawLine(context, from, to) {
        context.beginPath();
        context.moveTo(...from);
        context.lineTo(...to);
        context.stroke();
    }

    function drawCurve(result) {
        const context = curve.getContext("2d"), width = curve.clientWidth, height = curve.clientHeight;
        const ratio = window.devicePixelRatio || 1, top = Math.max(1.2, 1.1 * result.mu2);
        const toPixels = (lambda, f) => [8 + lambda * (width - 16), height - 8 - f / top * (height - 16)];
        curve.width = width * ratio;
        curve.height = height * ratio;
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.strokeStyle = context.fillStyle = getComputedStyle(curve).color;
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

    // What a screen reader says, in a few digits, once nothing has changed for a while.
    let saying;
    function say(sentence) {
        clearTimeout(saying);
        saying = setTimeout(() => { element("said").textContent = sentence; }, 500);
    }

    function show(result) {
        const good = result.status === 0, list = x => "(" + x.map(xi => xi.toFixed(4)).join(", ") + ")";
        element("mu2").textContent = good ? result.mu2.toPrecision(DIGITS) : "no ellipsoid";
        element("lambda").textContent = good ? result.lambda.toPrecision(DIGITS) : "";
        element("verdict").textContent = !good ? "" : result.mu2 < 1 ? "they overlap" : "they are apart";
        element("distance").textContent = good ? result.distance.toPrecision(DIGITS) : "";
        element("point").textContent = good ? list(result.point) : "";
        element("normal").textContent = good ? list(result.normal) : "";
        const verdict = element("verdict").textContent, numbers = [result.mu2, result.distance].map(x => x.toPrecision(4));
        say(good ? `${verdict}: mu squared is ${numbers[0]}, the distance is ${numbers[1]}` : "no ellipsoid");
    }

    function update() {
        const result = evaluate();
        show(result);
        if (result.status === 0) {
            if (scene) scene.draw(state, result, selected);
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

    // A quaternion after a small turn about a vector.
    function turned(quaternion, turn) {
        const {w, x, y, z} = new THREE.Quaternion(turn.x / 2, turn.y / 2, turn.z / 2, 1).multiply(rotation(quaternion)).normalize();
        return [w, x, y, z];
    }

    // A motion in the view, right, up and towards the reader, as it is in space.
    const inSpace = (...x) => new THREE.Vector3(...x).applyQuaternion(rotation(state.view).conjugate());

    function move(k, motion) {
        const moved = new THREE.Vector3(...state.r12).addScaledVector(motion, k === 1 ? 1 : -1);
        state.r12 = moved.toArray();
    }

    function turn(k, motion) {
        state.quaternions[k] = turned(state.quaternions[k], motion);
    }

    function drag(k, dx, dy, turning) {
        if (k < 0) {
            state.view = turned(state.view, new THREE.Vector3(dy / 120, dx / 120, 0));
        } else if (turning) {
            turn(k, inSpace(dy / 80, dx / 80, 0));
        } else {
            move(k, inSpace(dx, -dy, 0).multiplyScalar(scene.unitsPerPixel(k)));
        }
        changed();
    }

    function listenToPointer() {
        let held = null;
        view.addEventListener("pointerdown", event => {
            const box = view.getBoundingClientRect();
            held = {k: scene.at(event.clientX - box.left, event.clientY - box.top), x: event.clientX, y: event.clientY};
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
            const [right, up, near] = (motions[event.key] || [0, 0, 0]).map(x => 0.1 * x);
            if (event.key === "1" || event.key === "2") selected = Number(event.key) - 1;
            else if (!(event.key in motions)) return;
            else if (event.shiftKey) turn(selected, inSpace(-up, right, near));
            else move(selected, inSpace(right, up, near));
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
    element("flat").hidden = Boolean(scene);
    view.querySelector("canvas").hidden = !scene;
    if (scene) listenToPointer();
    listenToKeys();
    listenToControls();
    window.addEventListener("hashchange", () => { fromAddress(); update(); });
    window.addEventListener("resize", update);
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", update);
    update();
})();
