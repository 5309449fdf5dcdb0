package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.Map;
import java.util.UUID;
import javax.imageio.ImageIO;
import org.dfra.core.geometry.FrameTree;
import org.dfra.core.query.QueryParser;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.PanTiltCommand.PointAt;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.geometry.Transform;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.proxy.effector.PanTiltProxy;
import org.dfra.river.proxy.sensor.AngularRateProxy;
import org.dfra.river.proxy.sensor.CameraProxy;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.effector.PanTiltServer;
import org.dfra.river.server.sensor.AngularRateServer;
import org.dfra.river.server.sensor.CameraServer;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.camera.MjpegDevice;
import org.dfra.sim.device.camera.MjpegDevice.MjpegOptions;
import org.dfra.sim.device.gyro.Dsp3000Device;
import org.dfra.sim.device.pantilt.PtuDevice;
import org.dfra.sim.physics.CameraInput;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * What stands on a robot's head, from its XML and properties to the proxy that is found by what it
 * can do.
 */
@Timeout(120)
class HeadDevicesTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  @Test
  void aPanTiltUnitIsFoundByItsLimitsAndTurnsItsFrame() throws Exception {
    try (DeviceEmulator unit = emulated(new PtuDevice((time, pan, tilt) -> {}, 9600, false));
        PanTiltServer server =
            served(PanTiltServer.class, PanTiltProxy.class, "pan_tilt", "ptu46", unit.url())
                .serve();
        JiniModuleDirectory directory = REGGIE.directory()) {
      ModuleListing<?> listing =
          find(
              directory,
              "PanTiltEffector with pan_tilt.maxPan >= 1.57 and pan_tilt.maxTilt >= 0.5"
                  + " and effector.commands contains PointAt");
      assertThat(listing.attributes()).asString().contains("maxPan=2.77", "frame=robot/pan_tilt");
      PanTiltProxy found = (PanTiltProxy) listing.module();
      PanTiltProxy elsewhere =
          new PanTiltProxy(found.server(), UUID.randomUUID(), found.identification());
      FrameTree tree = new FrameTree();
      try (CommandLease lease = elsewhere.acquireCommandLease(Duration.ofSeconds(10))) {
        assertThatThrownBy(() -> elsewhere.execute(lease.key(), new PointAt(3, 0, 1)))
            .as("%s", server)
            .isInstanceOf(IllegalArgumentException.class)
            .hasMessageContaining("pan of 3.0000 rad is above the limit of 2.7736 rad");
        elsewhere.execute(lease.key(), new PointAt(Math.PI / 4, Math.PI / 8, 2));
        await()
            .atMost(PATIENCE)
            .ignoreExceptionsInstanceOf(NotReadyException.class) // old for a moment
            .until(
                () -> elsewhere.panTiltState().pan() > 0.7 && !elsewhere.panTiltState().isMoving());
        assertThat(found.panTiltState().tilt()).isCloseTo(Math.PI / 8, within(5e-4));
        tree.put(elsewhere);
      }
      tree.put("robot/camera", elsewhere.frame(), Transform.translation(0.1, 0, 0));
      Transform camera = tree.transform("robot/camera", "robot/base_link");
      assertThat(camera.z()).as("looks up").isCloseTo(0.1 * Math.sin(Math.PI / 8), within(1e-4));
      assertThat(camera.yaw()).as("looks left").isCloseTo(Math.PI / 4, within(5e-4));
      assertThat(elsewhere.test("identification").passed()).isTrue();
    }
  }

  @Test
  void aGyroIsFoundByItsRateAndReportsItsYawRate() throws Exception {
    try (DeviceEmulator gyro = emulated(new Dsp3000Device(time -> 0.5, 38_400, Duration.ZERO));
        AngularRateServer server =
            served(AngularRateServer.class, AngularRateProxy.class, "gyro", "dsp3000", gyro.url())
                .serve();
        JiniModuleDirectory directory = REGGIE.directory()) {
      ModuleListing<?> listing =
          find(
              directory,
              "AngularRateSensor with sensor.maxRate >= 100 and sensor.reading = AngularRate");
      assertThat(listing.attributes()).asString().contains("modes=[rate]");
      AngularRateProxy found = (AngularRateProxy) listing.module();
      AngularRateProxy elsewhere =
          new AngularRateProxy(found.server(), UUID.randomUUID(), found.identification());
      assertThat(elsewhere.awaitReadiness(PATIENCE)).as("%s", server).isEqualTo(Readiness.READY);
      assertThat(elsewhere.rate().rate()).isCloseTo(0.5, within(1e-7));
      assertThat(elsewhere.rate().frame()).isEqualTo("robot/gyro");
      assertThat(found.rate().rate()).isCloseTo(0.5, within(1e-7));
      assertThat(elsewhere.test("validity").passed()).isTrue();
      assertThat(elsewhere.recover("calibrate_bias_while_stationary").finding())
          .contains("is moving");
    }
  }

  @Test
  void camerasAreFoundByWhatTheySeeAndBringItThroughPixelByPixel() throws Exception {
    int width = 80;
    int height = 60;
    CameraInput ramp = time -> new CameraInput.Frame(width, height, ramp(width, height));
    int[] green = new int[width * height];
    Arrays.fill(green, 0x20A060);
    CameraInput lawn = time -> new CameraInput.Frame(width, height, green);
    try (DeviceEmulator light = emulated(new MjpegDevice(lawn, MjpegOptions.visible(10)));
        DeviceEmulator heat = emulated(new MjpegDevice(ramp, MjpegOptions.thermal(10)));
        CameraServer eye =
            served(CameraServer.class, CameraProxy.class, "camera", "mjpeg", light.url())
                .with("path", "/video")
                .with("field_of_view", "1.2")
                .serve();
        CameraServer thermal =
            served(CameraServer.class, CameraProxy.class, "thermal", "mjpeg-thermal", heat.url())
                .with("path", "/video")
                .with("field_of_view", "0.8")
                .with("mount_frame", "robot/pan_tilt")
                .serve();
        JiniModuleDirectory directory = REGGIE.directory()) {
      assertThat(eye.identification().name()).isNotEqualTo(thermal.identification().name());
      CameraImage seen =
          image(
              find(
                  directory,
                  "CameraSensor with camera.band = visible and camera.fieldOfView >= 1"
                      + " and camera.width >= 80"));
      assertThat(seen.frame()).isEqualTo("robot/camera");
      BufferedImage colours = ImageIO.read(new ByteArrayInputStream(seen.data()));
      assertThat(colours.getRGB(40, 30) >> 8 & 0xFF).isCloseTo(0xA0, within(4));
      ModuleListing<?> listing = find(directory, "CameraSensor with camera.band = thermal");
      assertThat(listing.attributes())
          .asString()
          .contains("band=THERMAL, width=80, height=60, fieldOfView=0.8", "parent=robot/pan_tilt");
      CameraImage felt = image(listing);
      assertThat(felt.focalLength()).isCloseTo(40 / Math.tan(0.4), within(1e-9));
      BufferedImage levels = ImageIO.read(new ByteArrayInputStream(felt.data()));
      assertThat(levels.getRaster().getSamples(0, 0, width, height, 0, (int[]) null))
          .isEqualTo(ramp(width, height));
      assertThat(((CameraProxy) listing.module()).test("image").finding())
          .startsWith("80 × 60 pixels, ")
          .endsWith(" bytes, -3.15 to 44.84 °C");
    }
  }

  /** The image by the network, as anybody has it who is elsewhere. */
  private static CameraImage image(ModuleListing<?> listing) throws RemoteException {
    CameraProxy found = (CameraProxy) listing.module();
    return new CameraProxy(found.server(), UUID.randomUUID(), found.identification()).image();
  }

  /** Hundredths of a kelvin: the next pixel is 0.01 K warmer. */
  private static int[] ramp(int width, int height) {
    int[] samples = new int[width * height];
    for (int i = 0; i < samples.length; i++) {
      samples[i] = 27_000 + i;
    }
    return samples;
  }

  private static ModuleListing<?> find(JiniModuleDirectory directory, String query)
      throws Exception {
    return directory
        .findFirst(new QueryParser(QueryTypeNames.standard()).parse(query), PATIENCE)
        .orElseThrow();
  }

  private static DeviceEmulator emulated(SerialDevice device) throws IOException {
    DeviceEmulator emulator = new DeviceEmulator("head", 0, device, InstantSource.system());
    emulator.start();
    return emulator;
  }

  /** As a robot's XML and the properties that come with DFRA describe it. */
  private <S extends ModuleServer<?>> ServedModule<S> served(
      Class<S> server,
      Class<? extends ModuleProxy<? extends Module>> proxy,
      String name,
      String properties,
      String link)
      throws Exception {
    return ServedModule.fromProperties(
            server, proxy, folder, name, properties, Map.of("link", link))
        .joining(REGGIE);
  }
}
