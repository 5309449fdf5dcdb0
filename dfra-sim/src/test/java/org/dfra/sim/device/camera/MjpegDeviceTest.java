package org.dfra.sim.device.camera;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.camera.MjpegDevice.MjpegOptions;
import org.dfra.sim.physics.CameraInput;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The camera alone, stepped, and asked by the JDK's own HTTP client. */
@Timeout(60)
class MjpegDeviceTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T10:00:00.25Z");
  private static final String GET = "GET /video HTTP/1.0\r\n\r\n";

  private Instant now = BEGIN;

  @Test
  void sendsAFrameAtOnceAndThenAtItsRate() {
    List<Instant> looks = new ArrayList<>();
    CameraInput view =
        time -> {
          looks.add(time);
          return TestPattern.light(16, 16).capture(time);
        };
    MjpegDevice camera = new MjpegDevice(view, MjpegOptions.visible(10));
    run(camera, 1000);
    assertThat(looks).as("nobody has asked").isEmpty();
    camera.connected();
    Instant asked = now;
    say(camera, GET);
    String output = new String(run(camera, 1000), ISO_8859_1);
    assertThat(looks).hasSize(11).startsWith(asked, asked.plusMillis(100));
    assertThat(output)
        .startsWith("HTTP/1.0 200 OK\r\n")
        .contains("boundary=dfra-frame\r\n\r\n--dfra-frame\r\nContent-Type: image/jpeg\r\n")
        .contains("X-Timestamp: " + asked.getEpochSecond() + ".255000\r\n");
    camera.disconnected();
    run(camera, 1000);
    assertThat(looks).as("nobody looks").hasSize(11);
  }

  @Test
  void leavesFramesOutWhereNobodyReads() {
    int[] looks = {0};
    MjpegDevice camera =
        new MjpegDevice(
            time -> {
              looks[0]++;
              return TestPattern.heat(64, 64).capture(time);
            },
            MjpegOptions.thermal(10));
    camera.connected();
    say(camera, GET);
    for (int i = 0; i < 400; i++) { // a byte a time, and the head takes 150
      camera.transmit(ByteBuffer.allocate(1), now);
      now = now.plusMillis(100);
    }
    assertThat(looks[0]).isEqualTo(1);
  }

  @Test
  void isTheSameEveryTime() {
    for (MjpegOptions options :
        new MjpegOptions[] {MjpegOptions.visible(10), MjpegOptions.thermal(10)}) {
      CameraInput view =
          options.band() == Band.THERMAL ? TestPattern.heat(40, 30) : TestPattern.light(40, 30);
      now = BEGIN;
      MjpegDevice one = new MjpegDevice(view, options);
      one.connected();
      say(one, GET);
      byte[] first = run(one, 500);
      now = BEGIN;
      MjpegDevice other = new MjpegDevice(view, options);
      other.connected();
      say(other, GET);
      assertThat(run(other, 500)).isEqualTo(first).hasSizeGreaterThan(1000);
    }
  }

  @Test
  void refusesWhatItShould() {
    assertThat(answer("GET /video HTTP/1.0\r\n\r\n", null)).startsWith("HTTP/1.0 200 ");
    assertThat(answer("GET / HTTP/1.0\r\n\r\n", null)).startsWith("HTTP/1.0 404 ");
    assertThat(answer("POST /video HTTP/1.0\r\n\r\n", null)).startsWith("HTTP/1.0 405 ");
    assertThat(answer("hello\r\n\r\n", null)).startsWith("HTTP/1.0 400 ");
    assertThat(answer("x".repeat(9000), null)).startsWith("HTTP/1.0 431 ");
    assertThat(answer(GET, "me:you")).startsWith("HTTP/1.0 401 ").contains("Basic realm=");
    assertThat(answer("GET /video HTTP/1.0\r\nAuthorization: Basic bWU6eW91\r\n\r\n", "me:you"))
        .startsWith("HTTP/1.0 200 ");
    assertThat(answer("GET /video HTTP/1.0\r\nAuthorization: Basic bWU6bWU=\r\n\r\n", "me:you"))
        .startsWith("HTTP/1.0 401 ");
  }

  @Test
  void speaksHttpAsTheJdksClientDoes() throws Exception {
    MjpegDevice camera = new MjpegDevice(TestPattern.light(64, 48), MjpegOptions.visible(50));
    try (DeviceEmulator emulator =
        new DeviceEmulator("camera", 0, camera, InstantSource.system())) {
      emulator.start();
      URI uri = URI.create("http://127.0.0.1:" + emulator.port() + "/video");
      HttpClient client = HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
      HttpResponse<InputStream> response =
          client.send(
              HttpRequest.newBuilder(uri).timeout(Duration.ofSeconds(20)).build(),
              BodyHandlers.ofInputStream());
      assertThat(response.statusCode()).isEqualTo(200);
      assertThat(response.headers().firstValue("content-type"))
          .contains("multipart/x-mixed-replace;boundary=dfra-frame");
      try (InputStream body = response.body()) {
        String some = new String(body.readNBytes(20_000), ISO_8859_1);
        assertThat(some.split("--dfra-frame\r\nContent-Type: image/jpeg\r\n"))
            .hasSizeGreaterThan(3);
      }
      HttpResponse<String> missing =
          client.send(
              HttpRequest.newBuilder(uri.resolve("/other")).build(), BodyHandlers.ofString());
      assertThat(missing.statusCode()).isEqualTo(404);
      assertThat(missing.body()).isEqualTo("404 Not Found\n");
    }
  }

  private String answer(String request, String credentials) {
    MjpegOptions options = MjpegOptions.visible(10);
    MjpegDevice camera =
        new MjpegDevice(
            TestPattern.light(8, 8),
            credentials == null ? options : options.withCredentials(credentials));
    camera.connected();
    say(camera, request);
    return new String(run(camera, 10), ISO_8859_1);
  }

  private void say(MjpegDevice camera, String text) {
    byte[] bytes = text.getBytes(ISO_8859_1);
    int half = bytes.length / 2;
    camera.receive(bytes, 0, half, now);
    camera.receive(bytes, half, bytes.length - half, now);
  }

  private byte[] run(MjpegDevice camera, int millis) {
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    for (int i = 0; i <= millis; i += 5) {
      ByteBuffer out = ByteBuffer.allocate(100_000);
      camera.transmit(out, now);
      output.write(out.array(), 0, out.position());
      now = now.plusMillis(5);
    }
    return output.toByteArray();
  }
}
