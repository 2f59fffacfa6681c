// Babylon.js: its glTF loader and HDRCubeTexture on a skybox. The light is not filtered: smooth surfaces do not need it, and on
// SwiftShader it takes most of a minute.
import { Engine } from "@babylonjs/core/Engines/engine.js";
import { Scene } from "@babylonjs/core/scene.js";
import { ArcRotateCamera } from "@babylonjs/core/Cameras/arcRotateCamera.js";
import { Vector3 } from "@babylonjs/core/Maths/math.vector.js";
import { HDRCubeTexture } from "@babylonjs/core/Materials/Textures/hdrCubeTexture.js";
import { LoadAssetContainerAsync } from "@babylonjs/core/Loading/sceneLoader.js";
import "@babylonjs/core/Helpers/sceneHelpers.js";
import "@babylonjs/loaders/glTF/2.0/glTFLoader.js";
import "@babylonjs/loaders/glTF/glTFFileLoader.js";
import "@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_transmission.js";
import "@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_ior.js";
import "@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_volume.js";
import { canvasIn, finished, run } from "../page.js";

run(async (host, { model, environment, width, height, fov, distance, multisampled }) => {
  const engine = new Engine(canvasIn(host, { width, height }), multisampled);
  const scene = new Scene(engine);
  scene.useRightHandedSystem = true;
  scene.imageProcessingConfiguration.toneMappingEnabled = false;
  const camera = new ArcRotateCamera("camera", Math.PI / 2, Math.PI / 2, distance, Vector3.Zero(), scene);
  Object.assign(camera, { fov, minZ: 0.1, maxZ: 10000 });
  const light = (url) => new Promise((resolve, reject) => {
    const texture = new HDRCubeTexture(url, scene, 512, false, true, false, false, () => resolve(texture), (message, error) => reject(error ?? new Error(message)), true);
  });
  const draw = (angle) => {
    camera.alpha = Math.PI / 2 - angle;
    scene.render();
    finished(engine._gl);
  };
  const [loaded, texture] = await Promise.all([LoadAssetContainerAsync(model, scene), light(environment)]);
  loaded.addAllToScene();
  scene.environmentTexture = texture;
  const box = scene.createDefaultSkybox(texture, true, 1000, 0, false);
  await scene.whenReadyAsync();
  draw(0);
  return {
    async frame(angle) { draw(angle); },
    async light(bytes) {
      const next = await light(URL.createObjectURL(new Blob([bytes])));
      scene.environmentTexture = next;
      box.material.reflectionTexture = next.clone();
      box.material.reflectionTexture.coordinatesMode = 5; // skybox
      await scene.whenReadyAsync();
      draw(0);
    },
    async rest() { draw(0); },
  };
});
