package org.dfra.sim.device.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitNoLink;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.awaitReadiness;
import static org.dfra.sim.device.Modules.awaitRecovered;
import static org.dfra.sim.device.Modules.number;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.camera.mjpeg.MjpegCameraImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.camera.MjpegDevice.MjpegOptions;
import org.dfra.sim.physics.CameraInput;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The real driver and the emulated camera over TCP, in real time. */
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class MjpegDriverTest {

  @Test
  void bringsHeatThroughPixelByPixel() throws Exception {
    try (DeviceEmulator camera = emulated(TestPattern.heat(160, 120), MjpegOptions.thermal(20));
        MjpegCameraImpl driver = driver(camera.url(), Map.of("band", "thermal"))) {
      List<CameraImage> images = take(driver, 20);
      for (CameraImage image : images) {
        BufferedImage decoded = decoded(image);
        assertThat(decoded.getSampleModel().getSampleSize(0)).isEqualTo(16);
        Instant second = image.measured();
        for (int i = 0; i < 160 * 120; i++) {
          assertThat(decoded.getRaster().getSample(i % 160, i / 160, 0))
              .isEqualTo(TestPattern.centikelvin(i, second));
        }
      }
      assertDistinct(images);
    }
  }

  @Test
  void bringsLightThroughAsNearAsJpegDoes() throws Exception {
    try (DeviceEmulator camera = emulated(TestPattern.light(320, 240), MjpegOptions.visible(20));
        MjpegCameraImpl driver = driver(camera.url(), Map.of("idle_period", "0"))) {
      List<CameraImage> images = take(driver, 20);
      for (CameraImage image : images) {
        BufferedImage decoded = decoded(image);
        for (int y = 0; y < 240; y += 3) {
          for (int x = 0; x < 320; x += 3) {
            int colour = decoded.getRGB(x, y);
            // Smooth ramps at a quality of 0.85: a few levels are lost, mostly of the colours.
            assertNear(colour >> 16 & 0xFF, TestPattern.red(x, 320), 12);
            assertNear(colour >> 8 & 0xFF, TestPattern.green(y, 240), 12);
            assertNear(colour & 0xFF, TestPattern.blue(image.measured()), 12);
          }
        }
      }
      assertDistinct(images);
      // It does not rest before its first client or after the last: that would cut an image short.
      assertThat(number(driver, "malformed_frames")).isZero();
      assertThat(number(driver, "dropped_bytes")).isZero();
    }
  }

  @Test
  void readsCamerasThatSendNeitherLengthNorTime() throws Exception {
    MjpegOptions terse = MjpegOptions.visible(20).withoutPartHeaders();
    try (DeviceEmulator camera = emulated(TestPattern.light(64, 48), terse);
        MjpegCameraImpl driver = driver(camera.url(), Map.of())) {
      List<CameraImage> images = take(driver, 5);
      assertThat(decoded(images.get(4)).getWidth()).isEqualTo(64);
      assertThat(Duration.between(images.get(0).measured(), Instant.now()))
          .isLessThan(Duration.ofMinutes(1));
    }
  }

  @Test
  void letsItselfBeKnown() throws Exception {
    MjpegOptions guarded = MjpegOptions.visible(20).withCredentials("robot:s3cret");
    try (DeviceEmulator camera = emulated(TestPattern.light(64, 48), guarded);
        MjpegCameraImpl stranger = driver(camera.url(), Map.of())) {
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(stranger::image)
                      .hasMessageContaining("the camera requires authentication"));
      stranger.close();
      try (MjpegCameraImpl known =
          driver(camera.url(), Map.of("user", "robot", "password", "s3cret"))) {
        awaitReadiness(known, Readiness.READY);
      }
    }
  }

  @Test
  void saysThatThePathIsWrong() throws Exception {
    try (DeviceEmulator camera = emulated(TestPattern.light(8, 8), MjpegOptions.visible(20));
        MjpegCameraImpl driver = driver(camera.url(), Map.of("path", "/stream"))) {
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(driver::image)
                      .isInstanceOf(NotReadyException.class)
                      .hasMessageEndingWith(
                          "the camera has nothing at /stream (404 Not Found); set path to its"
                              + " stream"));
    }
  }

  @Test
  void comesBackWhenTheCableWasPulledAndReadsOnThroughGarbage() throws Exception {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    try (DeviceEmulator camera = emulated(TestPattern.light(64, 48), MjpegOptions.visible(20));
        MjpegCameraImpl driver = driver(camera.url(), Map.of("idle_period", "0"))) {
      awaitReadiness(driver, Readiness.READY);
      camera.cable().unplug();
      awaitReadiness(driver, Readiness.INITIALIZING);
      awaitNoLink(driver);
      camera.cable().restore();
      awaitRecovered(driver, "reopen_link");
      awaitReadiness(driver, Readiness.READY);
      camera.cable().injectNoiseBursts(seed);
      await("-Ddfra.seed=" + seed).until(() -> number(driver, "dropped_bytes") > 50_000);
      camera.cable().restore();
      await("-Ddfra.seed=" + seed).until(driver::readiness, Readiness.READY::equals);
      Instant after = Instant.now();
      await("-Ddfra.seed=" + seed).until(() -> driver.image().measured().isAfter(after));
    }
  }

  @Test
  void noticesASilentCameraAndItsReturn() throws Exception {
    try (DeviceEmulator camera = emulated(TestPattern.light(64, 48), MjpegOptions.visible(20));
        MjpegCameraImpl driver = driver(camera.url(), Map.of("idle_period", "0"))) {
      awaitReadiness(driver, Readiness.READY);
      camera.cable().mute();
      awaitReadiness(driver, Readiness.INITIALIZING);
      camera.cable().restore();
      awaitReadiness(driver, Readiness.READY);
    }
  }

  @Test
  void restsWithoutClientsAndPassesItsTestsAllTheSame() throws Exception {
    int[] looks = {0};
    CameraInput view =
        time -> {
          looks[0]++;
          return TestPattern.light(64, 48).capture(time);
        };
    try (DeviceEmulator camera = emulated(view, MjpegOptions.visible(20));
        MjpegCameraImpl driver = driver(camera.url(), Map.of("idle_period", "0.5"))) {
      awaitReadiness(driver, Readiness.READY);
      awaitPassed(driver);
      assertThat(driver.tests()).containsExactly("link", "readings", "image");
      assertThat(awaitPassed(driver, "image").finding()).startsWith("64 × 48 pixels, ");
      Instant first = driver.image().measured();
      await().until(() -> driver.image().measured().isAfter(first));
      try (ModuleLease unused = driver.acquireLease(Duration.ofSeconds(30))) {
        assertThat(driver.readiness()).isEqualTo(Readiness.ACTIVE);
        List<CameraImage> images = take(driver, 20);
        // Twenty frames in a row, not one each half second.
        long millis =
            Duration.between(images.get(18).measured(), images.get(19).measured()).toMillis();
        assertThat(millis % 50).isZero();
      }
      assertThat(driver.history().failures()).isZero();
    }
  }

  private static void assertNear(int reported, int expected, int within) {
    assertThat(Math.abs(reported - expected))
        .as("%s for %s", reported, expected)
        .isLessThanOrEqualTo(within);
  }

  private static void assertDistinct(List<CameraImage> images) {
    assertThat(images.stream().map(CameraImage::measured)).doesNotHaveDuplicates().isSorted();
  }

  private static List<CameraImage> take(MjpegCameraImpl driver, int count) throws Exception {
    List<CameraImage> images = new CopyOnWriteArrayList<>();
    try (Subscription unused =
        driver.subscribe(
            delivery -> {
              if (delivery.event() instanceof NewReading reading
                  && reading.reading() instanceof CameraImage image) {
                images.add(image);
              }
            },
            DeliveryPolicy.keepLast(100))) {
      await().until(() -> images.size() >= count);
    }
    return images.subList(0, count);
  }

  private static BufferedImage decoded(CameraImage image) throws IOException {
    return ImageIO.read(new ByteArrayInputStream(image.data()));
  }

  private static DeviceEmulator emulated(CameraInput view, MjpegOptions options)
      throws IOException {
    DeviceEmulator made =
        new DeviceEmulator("camera", 0, new MjpegDevice(view, options), InstantSource.system());
    made.start();
    return made;
  }

  private static MjpegCameraImpl driver(String link, Map<String, String> more) {
    Map<String, String> all = new HashMap<>();
    all.put("link", link);
    all.put("path", "/video");
    all.put("field_of_view", "1");
    all.put("reopen_max_delay", "1");
    all.putAll(more);
    MjpegCameraImpl made =
        new MjpegCameraImpl(
            new ModuleContext(
                "atrv1", "camera", Parameters.of("atrv1/camera", all), InstantSource.system()));
    made.start();
    return made;
  }
}
