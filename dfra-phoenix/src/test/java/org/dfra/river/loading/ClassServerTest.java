package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.URL;
import java.net.URLConnection;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import net.jini.url.httpmd.Handler;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ClassServerTest {

  private static final String HOST = InetAddress.getLoopbackAddress().getHostAddress();
  private static final byte[] JAR = "the jar".getBytes(StandardCharsets.UTF_8);

  @TempDir private Path folder;
  private ClassServer server;

  @BeforeEach
  void start() throws IOException {
    Files.createDirectories(folder.resolve("dl/sub"));
    Files.write(folder.resolve("dl/a.jar"), JAR);
    for (String hidden : List.of("secret.jar", "dl/unlisted.jar", "dl/sub/a.jar")) {
      Files.writeString(folder.resolve(hidden), "not for you");
    }
    server = new ClassServer(HOST, 0, folder.resolve("dl"), List.of("a.jar"));
    server.start();
  }

  @AfterEach
  void close() {
    server.close();
  }

  @Test
  void servesAJarUnderItsAnnotation() throws Exception {
    assertThat(server.codebase("a.jar"))
        .isEqualTo(
            "httpmd://" + HOST + ":" + server.port() + "/a.jar;sha-256=" + Digests.sha256(JAR))
        .isEqualTo(server.codebase());
    CodebaseUrl url = CodebaseUrl.parse(server.codebase()).get(0);
    assertThat(new JarDownload(DownloadLimits.DEFAULT).fetch(url)).isEqualTo(JAR);
  }

  /** A class loader of River, where the handler of the URL loses the {@code #} of a fragment. */
  @Test
  void servesAJarToRiversOwnClients() throws Exception {
    assertThat(ask("GET", "/a.jarruntime").body()).isEqualTo(JAR);
    URL url = new URL(null, server.codebase(), new Handler());
    URLConnection connection = new URL(url, "#runtime", new Handler()).openConnection();
    try (InputStream in = connection.getInputStream()) {
      assertThat(in.readAllBytes()).isEqualTo(JAR);
    }
  }

  @Test
  void anotherVirtualMachineSaysTheSameAnnotation() throws Exception {
    assertThat(ClassServer.codebase(HOST, server.port(), folder.resolve("dl"), List.of("a.jar")))
        .isEqualTo(server.codebase());
  }

  @Test
  void answersHeadWithLengthAndNoBody() throws Exception {
    HttpResponse<byte[]> answer = ask("HEAD", "/a.jar");
    assertThat(answer.statusCode()).isEqualTo(200);
    assertThat(answer.headers().firstValueAsLong("content-length")).hasValue(JAR.length);
    assertThat(answer.body()).isEmpty();
  }

  @Test
  void refusesWhatOnlyReads() throws Exception {
    HttpResponse<byte[]> answer = ask("PUT", "/a.jar");
    assertThat(answer.statusCode()).isEqualTo(405);
    assertThat(answer.headers().firstValue("allow")).hasValue("GET, HEAD");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/",
        "/unlisted.jar",
        "/unlisted.jarruntime",
        "/a.jarruntimeruntime",
        "/../secret.jar",
        "/%2e%2e/secret.jar",
        "/..%2fsecret.jar",
        "/sub/a.jar",
        "//a.jar",
        "/a.jar/",
        "/a.jar;sha-256=00",
        "/a.jar%00.txt"
      })
  void hasNothingElseToAskFor(String path) throws Exception {
    assertThat(rawStatus(path)).as(path).isEqualTo("HTTP/1.1 404 Not Found");
  }

  @Test
  void servesWhatItDigestedAlsoWhenTheJarIsRebuiltMeanwhile() throws Exception {
    String before = server.codebase();
    Files.writeString(folder.resolve("dl/a.jar"), "rebuilt");
    assertThat(ask("GET", "/a.jar").body()).isEqualTo(JAR);
    assertThat(server.codebase()).isEqualTo(before);
  }

  @Test
  void hasTheSamePlaceAndTheNewDigestAfterARestart() throws Exception {
    int port = server.port();
    String before = server.codebase();
    Files.writeString(folder.resolve("dl/a.jar"), "rebuilt");
    server.close();
    server.close();
    server = new ClassServer(HOST, port, folder.resolve("dl"), List.of("a.jar"));
    server.start();
    server.start();
    assertThat(server.port()).isEqualTo(port);
    assertThat(server.codebase())
        .isNotEqualTo(before)
        .startsWith(before.substring(0, before.indexOf(';')));
    assertThat(new String(ask("GET", "/a.jar").body(), StandardCharsets.UTF_8))
        .isEqualTo("rebuilt");
  }

  @Test
  void saysWhoHasItsPort() {
    ClassServer second =
        new ClassServer(HOST, server.port(), folder.resolve("dl"), List.of("a.jar"));
    assertThatThrownBy(second::start)
        .isInstanceOf(IOException.class)
        .hasMessageContaining("cannot listen on " + HOST + ":" + server.port())
        .hasMessageContaining("name another address or port");
  }

  @Test
  void saysWhichJarIsMissing() {
    ClassServer without = new ClassServer(HOST, 0, folder, List.of("missing.jar"));
    assertThatThrownBy(without::start)
        .isInstanceOf(IOException.class)
        .hasMessageContaining(folder.resolve("missing.jar").toString())
        .hasMessageContaining("build it first");
  }

  @Test
  void saysWhatItDoesNotServe() {
    assertThatThrownBy(() -> server.codebase("b.jar"))
        .hasMessage("the class server does not serve b.jar, only [a.jar]; add it there");
    assertThatThrownBy(() -> new ClassServer(HOST, 0, folder, List.of("../secret.jar")))
        .hasMessageContaining("\"../secret.jar\" is not the name of a jar");
    server.close();
    assertThatThrownBy(() -> server.codebase()).hasMessageContaining("is not started");
  }

  private HttpResponse<byte[]> ask(String method, String path) throws Exception {
    return HttpClient.newHttpClient()
        .send(
            HttpRequest.newBuilder(URI.create("http://" + HOST + ":" + server.port() + path))
                .method(method, HttpRequest.BodyPublishers.noBody())
                .build(),
            HttpResponse.BodyHandlers.ofByteArray());
  }

  /** Sends the path as it is; an HTTP client would tidy it up. */
  private String rawStatus(String path) throws IOException {
    try (Socket socket = new Socket(HOST, server.port())) {
      OutputStream out = socket.getOutputStream();
      out.write(
          ("GET " + path + " HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n")
              .getBytes(StandardCharsets.US_ASCII));
      InputStream in = socket.getInputStream();
      return new String(in.readAllBytes(), StandardCharsets.US_ASCII).lines().findFirst().get();
    }
  }
}
