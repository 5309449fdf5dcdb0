package org.dfra.drivers.camera.mjpeg;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.context;
import static org.dfra.drivers.fixture.Modules.texts;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Map;
import java.util.Random;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.fixture.Modules;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.CameraAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver alone: the test is the camera and the time. */
@Timeout(120)
class MjpegCameraImplTest {

  private static final String URL = "tcp://camera:8080";
  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");
  private static final String STREAM =
      "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace;boundary=b\r\n\r\n";

  private final StepTicker ticker = new StepTicker(false);
  private final ScriptedLinks links = new ScriptedLinks(URL);
  private final ScriptedLink link = new ScriptedLink(URL);
  private final byte[] jpeg = Images.jpeg(32, 24, new Random(1));
  private MjpegCameraImpl camera;

  @AfterEach
  void end() {
    if (camera != null) {
      camera.close();
    }
  }

  @Test
  void asksForTheStreamAndServesItsImages() {
    start("path", "/video?size=small", "idle_period", "0");
    await().until(() -> !link.written().isEmpty());
    assertThat(new String(link.written().get(0), ISO_8859_1))
        .startsWith("GET /video?size=small HTTP/1.0\r\nHost: camera:8080\r\n")
        .endsWith("\r\n\r\n")
        .doesNotContain("Authorization");
    say(STREAM, part("", jpeg));
    awaitReadiness(Readiness.READY);
    CameraImage image = camera.image();
    assertThat(image.data()).isEqualTo(jpeg);
    assertThat(image.width()).isEqualTo(32);
    assertThat(image.height()).isEqualTo(24);
    assertThat(image.band()).isEqualTo(Band.VISIBLE);
    assertThat(image.mediaType()).isEqualTo("image/jpeg");
    assertThat(image.frame()).isEqualTo("atrv1/camera");
    assertThat(image.measured()).as("by arrival").isEqualTo(NOW);
    // Half of 32 pixels at half of 60°.
    assertThat(image.focalLength()).isCloseTo(16 / Math.tan(Math.PI / 6), within(1e-9));
    assertThat(camera.attributes())
        .contains(new CameraAttributes(Band.VISIBLE, 32, 24, 1.0471975511965976));
    camera.setParameter("field_of_view", "2");
    say(part("", jpeg));
    await().until(() -> Math.abs(camera.image().focalLength() - 16 / Math.tan(1)) < 1e-9);
  }

  @Test
  void takesTheCamerasTimeWhereItCanBeRight() {
    start("idle_period", "0");
    long now = NOW.getEpochSecond();
    say(STREAM, part("X-Timestamp: " + (now - 3) + ".25\r\n", jpeg));
    awaitReadiness(Readiness.READY);
    assertThat(camera.image().measured()).isEqualTo(NOW.minusMillis(2750));
    for (String wrong : new String[] {"86400.5", now + 3600 + "", "soon", "-1", "9999999999"}) {
      say(part("X-Timestamp: " + (now - 3) + ".25\r\n", jpeg));
      await().until(() -> camera.image().measured().isBefore(NOW));
      say(part("X-Timestamp: " + wrong + "\r\n", jpeg));
      await(wrong).until(() -> camera.image().measured().equals(NOW));
    }
  }

  @Test
  void saysInASentenceWhyThereIsNoStream() {
    assertTrouble(
        "HTTP/1.0 401 Unauthorized\r\nWWW-Authenticate: Basic realm=x\r\n\r\n",
        "the camera requires authentication (401 Unauthorized); set user and password");
    assertTrouble(
        "HTTP/1.0 401 No\r\nWWW-Authenticate: Digest realm=x, nonce=y\r\n\r\n",
        "the camera requires authentication by digest (401 No), but only basic is supported; set"
            + " the camera to basic");
    assertTrouble(
        "HTTP/1.1 404 Not Found\r\n\r\nno such page",
        "the camera has nothing at / (404 Not Found); set path to its stream");
    assertTrouble(
        "HTTP/1.1 302 Found\r\nLocation: http://me:secret@other/x\r\n\r\n",
        "the camera redirects to \"http://other/x\" (302 Found); set link and path to where its"
            + " stream is");
    assertTrouble("HTTP/1.1 503 Busy\r\n\r\n", "the camera answers 503 Busy; look at the camera");
    assertTrouble(
        "HTTP/1.1 200 OK\r\nContent-Type: text/html; charset=utf-8\r\n\r\n<html>",
        "the content of / is not a stream of images but text/html; charset=utf-8; set path to the"
            + " camera's multipart stream");
    assertTrouble("SSH-2.0-x\r\n", "the answer is not HTTP");
    assertTrouble(STREAM + "--b--\r\n", "the camera has ended its stream");
  }

  private void assertTrouble(String answer, String sentence) {
    links.clear();
    ScriptedLink wrong = links.add();
    try (MjpegCameraImpl refused = driver("field_of_view", "1")) {
      refused.start();
      wrong.say(answer.getBytes(ISO_8859_1));
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(refused::image)
                      .isInstanceOf(NotReadyException.class)
                      .hasMessage("atrv1/camera is INITIALIZING: " + URL + ": " + sentence));
    }
  }

  @Test
  void showsItsPasswordToTheCameraOnly() {
    links.add(link);
    camera = driver("field_of_view", "1", "user", "robot", "password", "s3cret:x");
    camera.start();
    await().until(() -> !link.written().isEmpty());
    assertThat(new String(link.written().get(0), ISO_8859_1))
        .contains("Authorization: Basic cm9ib3Q6czNjcmV0Ong=\r\n");
    assertThat(camera.parameters().toString()).contains("robot").doesNotContain("s3cret");
    assertThat(Parameters.of("x", Map.of("password", "s3cret")).toString())
        .doesNotContain("s3cret");
    link.say("HTTP/1.0 401 Unauthorized\r\n\r\n".getBytes(ISO_8859_1));
    await()
        .untilAsserted(
            () ->
                assertThatThrownBy(camera::image)
                    .hasMessageEndingWith(
                        "the camera rejects user robot with this password (401"
                            + " Unauthorized); set user and password"));
    assertThatThrownBy(() -> camera.setParameter("password", "other"))
        .hasMessageContaining("cannot be set while it runs")
        .hasMessageNotContaining("other");
  }

  @Test
  void restsWithoutClientsAndTakesAnImageNowAndThen() throws Exception {
    ScriptedLink second = new ScriptedLink(URL);
    ScriptedLink third = new ScriptedLink(URL);
    start("idle_period", "20");
    say(STREAM, part("", jpeg), part("", jpeg));
    awaitReadiness(Readiness.READY);
    await().until(() -> !link.isOpen());
    assertThat(camera.updateRate()).isEqualTo(0.05);
    links.add(second);
    ticker.step(Duration.ofSeconds(19));
    assertThat(camera.image().data()).as("old, but it rests").isEqualTo(jpeg);
    assertThat(camera.test("link").passed()).isTrue();
    assertThat(second.written()).isEmpty();
    ticker.step(Duration.ofSeconds(1));
    await().until(() -> !second.written().isEmpty());
    byte[] other = Images.jpeg(8, 8, new Random(2));
    second.say(bytes(STREAM, part("", other)));
    await().until(() -> camera.image().width() == 8);
    await().until(() -> !second.isOpen());
    links.add(third);
    ticker.step(Duration.ofSeconds(15));
    try (ModuleLease unused = camera.acquireLease(Duration.ofSeconds(10))) {
      await().until(() -> !third.written().isEmpty());
      assertThat(camera.updateRate()).isEqualTo(10);
      third.say(bytes(STREAM, part("", jpeg)));
      await().until(() -> camera.image().width() == 32);
      ticker.step(Duration.ofMillis(4900));
      third.say(bytes(part("", jpeg)));
      await().until(() -> third.isTaken());
      assertThat(third.isOpen()).as("it streams for its client").isTrue();
    }
    await().until(() -> !third.isOpen());
    assertThat(camera.readiness()).isEqualTo(Readiness.READY);
    assertThat(camera.history().failures()).isZero();
  }

  @Test
  void noticesACameraThatIsGoneWhileItRests() {
    start("idle_period", "20");
    say(STREAM, part("", jpeg));
    await().until(() -> !link.isOpen());
    ticker.step(Duration.ofSeconds(20)); // nobody answers
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(camera::image).hasMessageEndingWith(URL + ": refused");
    assertThat(camera.history().failures()).isEqualTo(1);
  }

  @Test
  void reopensAStreamWithoutImages() {
    start("idle_period", "0");
    say(STREAM, part("", jpeg));
    awaitReadiness(Readiness.READY);
    ScriptedLink second = links.add();
    ticker.step(Duration.ofMillis(5001));
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(camera::image).hasMessageEndingWith("no image for 5 s");
    await()
        .until(
            () -> {
              ticker.step(Duration.ofMillis(100));
              return !second.written().isEmpty();
            });
    second.say(bytes(STREAM, part("", jpeg)));
    awaitReadiness(Readiness.READY);
  }

  @Test
  void namesTheWrongKindOfImageRatherThanSilence() {
    start("band", "thermal", "idle_period", "0");
    for (int i = 0; i < 4; i++) { // the last at 4.5 s
      say(i == 0 ? STREAM : "", part("", jpeg));
      awaitRefusal();
      ticker.step(Duration.ofMillis(1500));
    }
    await().until(() -> !link.isOpen());
    assertThatThrownBy(camera::image).hasMessageContaining("image/jpeg of 8 bits");
  }

  @Test
  void namesTheSilenceOfACameraThatHasSentAWrongImageBefore() {
    start("band", "thermal", "idle_period", "0");
    say(STREAM, part("", jpeg));
    awaitRefusal();
    ticker.step(Duration.ofMillis(5001));
    await().until(() -> !link.isOpen());
    assertThatThrownBy(camera::image).hasMessageEndingWith("no image for 5 s");
  }

  private void awaitRefusal() {
    await()
        .untilAsserted(
            () -> assertThatThrownBy(camera::image).hasMessageContaining("image/jpeg of 8 bits"));
    await().until(() -> link.isTaken());
  }

  @Test
  void takesNoImageOfTheWrongKind() {
    start("band", "thermal", "idle_period", "0");
    byte[] heat = Images.heat(16, 12, new Random(3));
    say(STREAM, part("", jpeg));
    await()
        .untilAsserted(
            () ->
                assertThatThrownBy(camera::image)
                    .hasMessageEndingWith(
                        "the camera sends image/jpeg of 8 bits, but band thermal is image/png, grey"
                            + " with 16 bits"));
    say(part("", Images.colourPng(4, 4)));
    await()
        .untilAsserted(
            () -> assertThatThrownBy(camera::image).hasMessageContaining("image/png of 8 bits"));
    say(part("", heat));
    awaitReadiness(Readiness.READY);
    assertThat(camera.image().band()).isEqualTo(Band.THERMAL);
    assertThat(camera.image().data()).isEqualTo(heat);
    assertThat(ImageDiagnostics.of(camera.image()).text())
        .matches("16 × 12 pixels, \\d+ bytes, 1[67]\\.\\d\\d to 2[67]\\.\\d\\d °C");
  }

  @Test
  void seesWhenTheLensIsCovered() {
    CameraImage dark =
        new CameraImage(NOW, "a/b", Band.VISIBLE, 4, 4, 3, "image/png", Images.colourPng(4, 4));
    assertThat(ImageDiagnostics.of(dark).passed()).isFalse();
    assertThat(ImageDiagnostics.of(dark).text()).endsWith("is the lens covered?");
    byte[] cut = jpeg.clone();
    Arrays.fill(cut, 20, cut.length - 2, (byte) 0);
    CameraImage spoilt = new CameraImage(NOW, "a/b", Band.VISIBLE, 4, 4, 3, "image/jpeg", cut);
    assertThat(ImageDiagnostics.of(spoilt).text()).startsWith("the image cannot be decoded");
  }

  @Test
  void refusesParametersThatAreNone() {
    String[][] wrong = {
      {"field_of_view", "4", "is \"4\", which is not a number from 0.001 to 3.1"},
      {"band", "infrared", "is \"infrared\", which is not visible or thermal"},
      {"path", "video", "is \"video\", which is not a path: it begins with a slash"},
      {"path", "/a b", "is \"/a b\", which is not a path"},
      {"path", "/\r\nX: y", "which is not a path"},
      {"user", "a:b", "is \"a:b\", which is not a user's name without colons"},
      {"link", "serial:/dev/ttyS0", "which is not a network camera's; write tcp://host:port"},
      {"max_image_bytes", "10", "is \"10\", which is not a number from 10000 to 67108864"},
      {"idle_period", "-1", "is \"-1\", which is not a number from 0 to 3600"},
    };
    for (String[] each : wrong) {
      assertThatThrownBy(() -> driver(each[0], each[1]))
          .isInstanceOf(ConfigurationException.class)
          .hasMessageContaining("parameter " + each[0])
          .hasMessageContaining(each[2]);
    }
    assertThatThrownBy(() -> driver("password", "s3cret"))
        .hasMessageContaining("parameter user is not set")
        .hasMessageNotContaining("s3cret");
    assertThatThrownBy(
            () ->
                new MjpegCameraImpl(
                    new ModuleContext(
                        "a", "b", Parameters.of("a/b", Map.of("link", URL)), () -> NOW)))
        .hasMessageContaining("parameter field_of_view is not set");
  }

  private void start(String... texts) {
    links.add(link);
    camera = driver(texts);
    camera.start();
  }

  private MjpegCameraImpl driver(String... texts) {
    Map<String, String> all = texts("link", URL, "field_of_view", "1.0471975511965976");
    all.putAll(texts(texts));
    return new MjpegCameraImpl(context("camera", all, () -> NOW), ticker, links);
  }

  private void say(Object... pieces) {
    link.say(bytes(pieces));
  }

  private static byte[] part(String headers, byte[] image) {
    return bytes(
        "--b\r\nContent-Length: " + image.length + "\r\n" + headers + "\r\n", image, "\r\n");
  }

  private static byte[] bytes(Object... pieces) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (Object piece : pieces) {
      all.writeBytes(piece instanceof byte[] raw ? raw : ((String) piece).getBytes(ISO_8859_1));
    }
    return all.toByteArray();
  }

  private void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(camera, expected);
  }
}
