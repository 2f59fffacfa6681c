// Filament: cmgen's cube maps, since it reads no .hdr in the browser; gltfio's materials.
import { canvasIn, fetched, finished, run } from "../page.js";

run(async (host, { model, filtered, width, height, fov, distance, multisampled }) => {
  await new Promise((resolve) => Filament.init([], resolve));
  const canvas = canvasIn(host, { width, height });
  const engine = Filament.Engine.create(canvas);
  const gl = canvas.getContext("webgl2");
  const scene = engine.createScene();
  const swapChain = engine.createSwapChain();
  const renderer = engine.createRenderer();
  const camera = engine.createCamera(Filament.EntityManager.get().create());
  camera.setProjectionFov((fov * 180) / Math.PI, width / height, 0.1, 100, Filament.Camera$Fov.VERTICAL);
  camera.setExposureDirect(1);
  const view = engine.createView();
  view.setCamera(camera);
  view.setScene(scene);
  view.setViewport([0, 0, width, height]);
  view.setMultiSampleAntiAliasingOptions({ enabled: multisampled, sampleCount: 4 });
  view.setAntiAliasing(Filament.View$AntiAliasing.NONE); // FXAA would blur it
  view.setColorGrading(Filament.ColorGrading.Builder().toneMapping(Filament.ColorGrading$ToneMapping.LINEAR).build(engine));
  const take = ([reflections, sky]) => {
    const indirect = engine.createIblFromKtx1(reflections);
    indirect.setIntensity(1);
    scene.setIndirectLight(indirect);
    scene.setSkybox(engine.createSkyFromKtx1(sky));
  };
  const draw = (angle) => {
    camera.lookAt([distance * Math.sin(angle), 0, distance * Math.cos(angle)], [0, 0, 0], [0, 1, 0]);
    renderer.render(swapChain, view);
    engine.execute();
    finished(gl);
  };
  const [glb, ...cubes] = await Promise.all([model, ...filtered].map(fetched));
  take(cubes);
  const asset = engine.createAssetLoader().createAsset(glb);
  await new Promise((resolve) => asset.loadResources(resolve, null, null, null));
  scene.addEntities(asset.getEntities());
  draw(0);
  return {
    async frame(angle) {
      await new Promise(requestAnimationFrame); // or it skips the frame
      draw(angle);
    },
    async light() {
      take(cubes);
      draw(0);
    },
    async rest() { for (let i = 0; i < 3; i++) draw(0); },
  };
});
