package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.dfra.river.fixture.SignerKey;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which code is not loaded: what nobody trusts, what was altered, what does not come in time. */
class CodeRefusalTest extends ServedJarFixture {

  private static SignerKey stranger;
  private static SignerKey expired;

  @BeforeAll
  static void makeOtherKeys() throws Exception {
    stranger = SignerKey.create(keys, "stranger");
    expired = SignerKey.create(keys, "expired", "-10d", 2);
  }

  @Test
  void aDigestInTheUrlIsNoTrust() throws Exception {
    String codebase = serve();
    assertRefused(
        new VerifiedClassProvider(CodeTrust.NONE),
        codebase,
        "its digest is not pinned, and no key is trusted to" + " sign code");
    assertRefused(
        trusting(team), codebase, "the jar is not signed, and its digest alone says nothing");
  }

  @Test
  void refusesAnUnknownKey() throws Exception {
    stranger.sign(jar);
    assertRefused(
        trusting(team), serve(), "is signed by CN=stranger, whose key is not trusted here");
  }

  @Test
  void refusesAnExpiredCertificate() throws Exception {
    expired.sign(jar);
    assertRefused(trusting(expired), serve(), "signer CN=expired is valid only from ");
  }

  @ParameterizedTest
  @ValueSource(strings = {"sample/lidar/More.class", "META-INF/services/java.lang.Runnable"})
  void refusesAJarWithOneUnsignedEntry(String name) throws Exception {
    team.sign(jar);
    add(name);
    assertRefused(trusting(team), serve(), "its entry " + name + " is not signed");
  }

  @Test
  void refusesAJarAlteredAfterItWasSigned() throws Exception {
    team.sign(jar);
    rewrite("sample/lidar/name.txt", "radar".getBytes(StandardCharsets.UTF_8));
    assertRefused(trusting(team), serve(), "it was altered after it was signed");
  }

  @Test
  void refusesAJarThatDoesNotFitItsDigest() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = pinning(codebase);
    server.close();
    rewrite("sample/lidar/name.txt", "radar".getBytes(StandardCharsets.UTF_8));
    server = new ClassServer(HOST, port(codebase), folder, List.of("lidar.jar"));
    server.start();
    assertRefused(provider, codebase, "what is served there has SHA-256 ");
  }

  @ParameterizedTest
  @ValueSource(strings = {"http", "file"})
  void refusesOtherUrlsByName(String scheme) throws Exception {
    String httpmd = serve();
    String codebase =
        scheme.equals("http")
            ? httpmd.replace("httpmd:", "http:").replaceAll(";.*", "")
            : jar.toUri().toString();
    assertRefused(pinning(httpmd), codebase, scheme + ": is not accepted");
  }

  @Test
  void refusesACodebaseOfWhichOnePartIsNotTrusted() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = pinning(codebase);
    String other = codebase.replaceAll("=.*", "=" + "0".repeat(64));
    assertRefused(provider, codebase + " " + other, "its digest is not pinned");
  }

  @Test
  void refusesWhatIsLargerThanAllowed() throws Exception {
    String codebase = serve();
    Set<String> pinned = Set.of(digest(codebase));
    assertRefused(
        new VerifiedClassProvider(
            new CodeTrust(
                Set.of(), pinned, new DownloadLimits(100, 1 << 20, 100, Duration.ofSeconds(5)))),
        codebase,
        "the jar is longer than 100 bytes");
    assertRefused(
        new VerifiedClassProvider(
            new CodeTrust(
                Set.of(), pinned, new DownloadLimits(1 << 20, 500, 100, Duration.ofSeconds(5)))),
        codebase,
        "it unpacks to more than 500 bytes");
  }

  @Test
  void followsNoRedirect() throws Exception {
    String target = serve();
    HttpServer redirect =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    redirect.createContext(
        "/",
        exchange -> {
          exchange
              .getResponseHeaders()
              .set("Location", CodebaseUrl.parse(target).get(0).location() + "");
          exchange.sendResponseHeaders(302, -1);
          exchange.close();
        });
    redirect.start();
    try {
      String codebase =
          target.replace(":" + port(target) + "/", ":" + redirect.getAddress().getPort() + "/");
      assertRefused(pinning(codebase), codebase, "answers 302 and redirects are not followed");
    } finally {
      redirect.stop(0);
    }
  }

  @Test
  void givesUpOnAServerThatTrickles() throws Exception {
    try (ServerSocket trickling = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      Thread server = new Thread(() -> trickle(trickling), "trickling server");
      server.setDaemon(true);
      server.start();
      String codebase =
          "httpmd://" + HOST + ":" + trickling.getLocalPort() + "/a.jar;sha-256=" + "0".repeat(64);
      DownloadLimits brief = new DownloadLimits(1 << 20, 1 << 20, 100, Duration.ofMillis(300));
      VerifiedClassProvider provider =
          new VerifiedClassProvider(new CodeTrust(Set.of(), Set.of(digest(codebase)), brief));
      assertThatThrownBy(() -> load(provider, codebase))
          .isInstanceOf(ClassNotFoundException.class)
          .hasMessageContaining("did not come within 300 ms");
    }
  }

  /** One byte of the body for each 20 ms, for ever. */
  private static void trickle(ServerSocket server) {
    try (var socket = server.accept();
        InputStream in = socket.getInputStream();
        OutputStream out = socket.getOutputStream()) {
      in.read();
      out.write(
          "HTTP/1.1 200 OK\r\nContent-Length: 9999\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
      while (true) {
        out.write(1);
        out.flush();
        java.util.concurrent.locks.LockSupport.parkNanos(20_000_000);
      }
    } catch (IOException e) {
      // the client is gone, as it should
    }
  }
}
