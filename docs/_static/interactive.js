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

    const pw85 = await PW85;
    const scene = makeScene(view.querySelector("canvas"), COLOURS);
    let state, selected = 1;

    // f at λ = 0, 0.01 ... 1, from the points x0 of the theory and their normals n: f(λ) = λ (n·x0)(n·r12)/(nᵀQ1n).
    function curveOf(r12, q1, q2) {
        const inside = Array.from({length: 99}, (_, i) => (i + 1) / 100);
        const {point, normal} = pw85.contactGeometryRows(r12, q1, q2, inside);
        const at = inside.map((lambda, i) => {
            const [x, y, z] = normal.subarray(3 * i), [px, py, pz] = point.subarray(3 * i), [xx, xy, xz, yy, yz, zz] = q1;
            const width = xx * x * x + yy * y * y + zz * z * z + 2 * (xy * x * y + xz * x * z + yz * y * z);
            return lambda * (x * px + y * py + z * pz) * (x * r12[0] + y * r12[1] + z * r12[2]) / width;
        });
        return [0, ...at, 0];
    }

    // What the page shows of the pair; null if the library refuses a number.
    function evaluate() {
        const {axes, quaternions, r12} = state;
        try {
            const [q1, q2] = axes.map((lengths, k) => pw85.ellipsoidQuaternion(lengths, quaternions[k]));
            const contact = pw85.contact(r12, q1, q2), {distance, point1, point2} = pw85.distance(r12, q1, q2);
            const isConcentric = r12.every(x => x === 0), none = [NaN, NaN, NaN]; // no point and no normal belong to such a pair
            const {point, normal} = isConcentric ? {point: none, normal: none} : pw85.contactGeometry(r12, q1, q2, contact.lambda);
            const f = isConcentric ? Array(101).fill(0) : curveOf(r12, q1, q2);
            const overlap = pw85.overlap(r12, q1, q2), closest = [[...point1], [...point2]];
            return {...contact, overlap, distance, closest, point: [...point], normal: [...normal], f};
        } catch (error) {
            if (error.name !== "Pw85Error") throw error;
            return null;
        }
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
        const good = result !== null, list = x => "(" + x.map(xi => xi.toFixed(4)).join(", ") + ")";
        element("mu2").textContent = good ? result.mu2.toPrecision(DIGITS) : "no ellipsoid";
        element("lambda").textContent = good ? result.lambda.toPrecision(DIGITS) : "";
        element("verdict").textContent = !good ? "" : result.overlap ? "they overlap" : "they are apart";
        element("distance").textContent = good ? result.distance.toPrecision(DIGITS) : "";
        element("point").textContent = good ? list(result.point) : "";
        element("normal").textContent = good ? list(result.normal) : "";
        const verdict = element("verdict").textContent;
        say(good ? `${verdict}: mu squared is ${result.mu2.toPrecision(4)}, the distance is ${result.distance.toPrecision(4)}` : "no ellipsoid");
    }

    function update() {
        const result = evaluate();
        show(result);
        if (result !== null) {
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
