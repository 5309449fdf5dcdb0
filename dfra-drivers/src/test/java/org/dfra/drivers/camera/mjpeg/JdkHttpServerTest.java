package org.dfra.drivers.camera.mjpeg;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.awaitReadiness;
import static org.dfra.drivers.fixture.Modules.context;
import static org.dfra.drivers.fixture.Modules.texts;

import com.sun.net.httpserver.BasicAuthenticator;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.InstantSource;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver against an HTTP server that was not written for it. */
@Timeout(120)
class JdkHttpServerTest {

  private final byte[] image = Images.jpeg(320, 240, new Random(1));
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private HttpServer server;

  @BeforeEach
  void start() throws IOException {
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.setExecutor(threads);
    server.createContext("/counted", exchange -> stream(exchange, true));
    server.createContext("/uncounted", exchange -> stream(exchange, false));
    server
        .createContext("/guarded", exchange -> stream(exchange, true))
        .setAuthenticator(
            new BasicAuthenticator("camera") {
              @Override
              public boolean checkCredentials(String user, String password) {
                return user.equals("robot") && password.equals("pass word");
              }
            });
    server.createContext(
        "/moved",
        exchange -> {
          exchange.getResponseHeaders().set("Location", "/counted");
          exchange.sendResponseHeaders(301, -1);
          exchange.close();
        });
    server.start();
  }

  @AfterEach
  void end() {
    server.stop(0);
    threads.shutdownNow();
  }

  /** Sends images until the client has gone, each written in pieces. */
  private void stream(HttpExchange exchange, boolean counted) throws IOException {
    exchange
        .getResponseHeaders()
        .set("Content-Type", "multipart/x-mixed-replace; boundary=\"--a b\"");
    exchange.sendResponseHeaders(200, 0);
    try (OutputStream out = exchange.getResponseBody()) {
      while (!Thread.currentThread().isInterrupted()) {
        String length = counted ? "Content-length: " + image.length + "\r\n" : "";
        out.write(("--a b\r\nContent-Type: image/jpeg\r\n" + length + "\r\n").getBytes(ISO_8859_1));
        out.write(image, 0, 1000);
        out.flush();
        out.write(image, 1000, image.length - 1000);
        out.write("\r\n".getBytes(ISO_8859_1));
        out.flush();
      }
    }
  }

  @Test
  void readsItsStreams() {
    for (String path : new String[] {"/counted", "/uncounted"}) {
      try (MjpegCameraImpl camera = camera("path", path, "idle_period", "0")) {
        awaitReadiness(camera, Readiness.READY);
        await()
            .until(() -> camera.parameters().toString().matches(".*name=frames, value=\\d{3}.*"));
        assertThat(camera.image().data()).as(path).isEqualTo(image);
        assertThat(camera.parameters().toString())
            .contains("name=dropped_bytes, value=0,")
            .contains("name=malformed_frames, value=0,");
      }
    }
  }

  @Test
  void isLetInByItsPassword() {
    try (MjpegCameraImpl camera =
        camera("path", "/guarded", "user", "robot", "password", "pass word")) {
      awaitReadiness(camera, Readiness.READY);
    }
    assertTrouble("the camera rejects user robot", "path", "/guarded", "user", "robot");
    assertTrouble("the camera requires authentication (401 Unauthorized)", "path", "/guarded");
  }

  @Test
  void saysWhatItAnswers() {
    assertTrouble("the camera has nothing at /other (404 Not Found)", "path", "/other");
    assertTrouble("the camera redirects to \"/counted\" (301 ", "path", "/moved");
  }

  private void assertTrouble(String part, String... texts) {
    try (MjpegCameraImpl camera = camera(texts)) {
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(camera::image)
                      .isInstanceOf(NotReadyException.class)
                      .hasMessageContaining(part));
    }
  }

  private MjpegCameraImpl camera(String... texts) {
    String link = "tcp://127.0.0.1:" + server.getAddress().getPort();
    Map<String, String> all = texts("link", link, "field_of_view", "1");
    all.putAll(texts(texts));
    MjpegCameraImpl made = new MjpegCameraImpl(context("camera", all, InstantSource.system()));
    made.start();
    return made;
  }
}
