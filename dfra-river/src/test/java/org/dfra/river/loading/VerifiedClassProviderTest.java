package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.assertj.core.api.AbstractThrowableAssert;
import org.dfra.river.fixture.SignerKey;
import org.dfra.river.fixture.TestCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class VerifiedClassProviderTest {

  private static final String HOST = InetAddress.getLoopbackAddress().getHostAddress();
  private static final String KIND = "sample.lidar.Lidar";
  private static final String RAN = "sample.lidar.ran";

  @TempDir private static Path keys;
  private static SignerKey team;
  private static SignerKey stranger;
  private static SignerKey expired;

  @TempDir private Path folder;
  private Path jar;
  private ClassServer server;

  @BeforeAll
  static void makeKeys() throws Exception {
    team = SignerKey.create(keys, "team");
    stranger = SignerKey.create(keys, "stranger");
    expired = SignerKey.create(keys, "expired", "-10d", 2);
  }

  @BeforeEach
  void build() throws IOException {
    System.clearProperty(RAN);
    Path classes =
        TestCode.compile(
            folder.resolve("classes"),
            Map.of(
                KIND,
                """
                package sample.lidar;
                public class Lidar implements java.io.Serializable {
                  static { System.setProperty("sample.lidar.ran", "yes"); }
                }
                """,
                "sample.lidar.RemoteLidar",
                "package sample.lidar; public interface RemoteLidar extends java.rmi.Remote {}",
                "sample.lidar.Hidden",
                "package sample.lidar; interface Hidden extends java.rmi.Remote {}"));
    Files.writeString(classes.resolve("sample/lidar/name.txt"), "lidar");
    jar = TestCode.jar(folder.resolve("lidar.jar"), classes);
  }

  @AfterEach
  void stop() {
    if (server != null) {
      server.close();
    }
  }

  @Test
  void loadsAPinnedJar() throws Exception {
    String codebase = serve();
    Class<?> loaded = load(pinning(codebase), codebase);
    assertThat(loaded.getName()).isEqualTo(KIND);
    assertThat(System.getProperty(RAN)).as("loading does not initialise").isNull();
    loaded.getConstructor().newInstance();
    assertThat(System.getProperty(RAN)).isEqualTo("yes");
    assertThat(new String(loaded.getResourceAsStream("name.txt").readAllBytes()))
        .isEqualTo("lidar");
  }

  @Test
  void loadsAJarSignedByATrustedKey() throws Exception {
    team.sign(jar);
    String codebase = serve();
    Class<?> loaded = load(trusting(team), codebase);
    assertThat(loaded.getProtectionDomain().getCodeSource().getCodeSigners()).hasSize(1);
  }

  @Test
  void loadsWhatAnAuthenticatedPeerVouchesForWithinItsCallOnly() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = new VerifiedClassProvider(CodeTrust.NONE);
    assertRefused(provider, codebase, "nobody vouches for it");
    try (AuthenticatedDigests.Scope scope = AuthenticatedDigests.open("CN=atrv1")) {
      scope.vouch(codebase);
      assertThat(load(provider, codebase).getName()).isEqualTo(KIND);
    }
    assertRefused(new VerifiedClassProvider(CodeTrust.NONE), codebase, "nobody vouches for it");
  }

  @Test
  void aDigestInTheUrlIsNoTrust() throws Exception {
    String codebase = serve();
    assertRefused(
        new VerifiedClassProvider(CodeTrust.NONE),
        codebase,
        "its digest is not pinned, nobody vouches for it, and no key is trusted to sign code");
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
  void loadsNothingFromEntriesThatNobodyNeedsToSign() throws Exception {
    team.sign(jar);
    add("META-INF/SIG-evil.class");
    String codebase = serve();
    assertThatThrownBy(() -> trusting(team).loadClass(codebase, "META-INF.SIG-evil", null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessageContaining("nor in codebase");
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
    assertRefused(pinning(httpmd), codebase, scheme + ": is not loaded from");
  }

  @Test
  void refusesACodebaseOfWhichOnePartIsNotTrusted() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = pinning(codebase);
    String other = codebase.replaceAll("=.*", "=" + "0".repeat(64));
    assertRefused(provider, codebase + " " + other, "its digest is not pinned");
  }

  @Test
  void equalAnnotationsGiveTheSameClassAndItTravelsOnUnderIts() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = pinning(codebase);
    Class<?> loaded = load(provider, codebase);
    server.close(); // what is loaded needs no server any more
    assertThat(load(provider, codebase)).isSameAs(loaded);
    assertThat(provider.getClassLoader(codebase)).isSameAs(loaded.getClassLoader());
    assertThat(provider.getClassAnnotation(loaded)).isEqualTo(codebase);
    assertThat(provider.loadClass(codebase, "[L" + KIND + ";", null).getComponentType())
        .isSameAs(loaded);
    assertThat(provider.getClassAnnotation(loaded.arrayType())).isEqualTo(codebase);
    assertThat(provider.getClassAnnotation(String.class)).isNull();
  }

  @Test
  void manyThreadsGetOneClass() throws Exception {
    team.sign(jar);
    String codebase = serve();
    VerifiedClassProvider provider = trusting(team);
    ExecutorService threads = Executors.newFixedThreadPool(16);
    try {
      List<Future<Class<?>>> loading = new ArrayList<>();
      for (int i = 0; i < 64; i++) {
        loading.add(threads.submit(() -> load(provider, codebase)));
      }
      for (Future<Class<?>> each : loading) {
        assertThat(each.get()).isSameAs(loading.get(0).get());
      }
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void theClassPathGoesFirst() throws Exception {
    VerifiedClassProvider provider = new VerifiedClassProvider(CodeTrust.NONE);
    assertThat(provider.loadClass("http://nowhere/", CodeTrust.class.getName(), null))
        .isSameAs(CodeTrust.class);
    assertThatThrownBy(() -> provider.loadClass(null, KIND, null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessageContaining("no codebase came with it");
    assertThatThrownBy(() -> provider.loadClass("http://nowhere/", "int", null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasNoCause();
  }

  @Test
  void loadsProxiesOfDownloadedInterfaces() throws Exception {
    String codebase = serve();
    VerifiedClassProvider provider = pinning(codebase);
    String[] interfaces = {
      "sample.lidar.RemoteLidar", "net.jini.core.constraint.RemoteMethodControl"
    };
    Class<?> proxy = provider.loadProxyClass(codebase, interfaces, null);
    assertThat(Proxy.isProxyClass(proxy)).isTrue();
    assertThat(provider.getClassAnnotation(proxy)).isEqualTo(codebase);
    assertThat(provider.loadProxyClass(codebase, new String[] {"sample.lidar.Hidden"}, null))
        .isNotNull();
    String[] local = {"java.lang.Runnable"};
    assertThat(Proxy.isProxyClass(provider.loadProxyClass(codebase, local, null))).isTrue();
    assertThatThrownBy(() -> provider.loadProxyClass("http://nowhere/", interfaces, null))
        .isInstanceOf(ClassNotFoundException.class)
        .hasMessageContaining("http: is not loaded from");
  }

  @Test
  void refusesWhatIsLargerThanAllowed() throws Exception {
    String codebase = serve();
    Set<String> pinned = Set.of(digest(codebase));
    assertRefused(
        new VerifiedClassProvider(
            new CodeTrust(
                Set.of(), pinned, new CodeLimits(100, 1 << 20, 100, Duration.ofSeconds(5)))),
        codebase,
        "the jar is longer than 100 bytes");
    assertRefused(
        new VerifiedClassProvider(
            new CodeTrust(
                Set.of(), pinned, new CodeLimits(1 << 20, 500, 100, Duration.ofSeconds(5)))),
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
      CodeLimits brief = new CodeLimits(1 << 20, 1 << 20, 100, Duration.ofMillis(300));
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

  private static void assertRefused(VerifiedClassProvider provider, String codebase, String why) {
    for (int i = 0; i < 2; i++) { // the second time it is remembered
      AbstractThrowableAssert<?, ?> refusal =
          assertThatThrownBy(() -> load(provider, codebase))
              .isInstanceOf(ClassNotFoundException.class)
              .hasMessageStartingWith(KIND + " was not loaded: codebase ")
              .hasMessageContaining(why)
              .hasMessageContaining("; ")
              .hasCauseInstanceOf(CodeRefusedException.class);
      assertThat(refusal).isNotNull();
    }
    assertThat(System.getProperty(RAN)).isNull();
  }

  private static Class<?> load(VerifiedClassProvider provider, String codebase)
      throws ClassNotFoundException {
    return provider.loadClass(codebase, KIND, null);
  }

  private static VerifiedClassProvider pinning(String codebase) {
    return new VerifiedClassProvider(
        new CodeTrust(Set.of(), Set.of(digest(codebase)), CodeLimits.DEFAULT));
  }

  private static VerifiedClassProvider trusting(SignerKey key) {
    return new VerifiedClassProvider(
        new CodeTrust(Set.of(key.certificate()), Set.of(), CodeLimits.DEFAULT));
  }

  private String serve() throws IOException {
    server = new ClassServer(HOST, 0, folder, List.of("lidar.jar"));
    server.start();
    return server.codebase();
  }

  private static String digest(String codebase) {
    return CodebaseUrl.parse(codebase).get(0).digest();
  }

  private static int port(String codebase) {
    return CodebaseUrl.parse(codebase).get(0).location().getPort();
  }

  private void add(String name) throws IOException {
    rewrite(name, Files.readAllBytes(folder.resolve("classes/sample/lidar/Lidar.class")));
  }

  /** Puts other content under a name, after all that the jar has. */
  private void rewrite(String name, byte[] content) throws IOException {
    Path altered = folder.resolve("altered.jar");
    try (ZipInputStream in = new ZipInputStream(Files.newInputStream(jar));
        ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(altered))) {
      for (ZipEntry entry; (entry = in.getNextEntry()) != null; ) {
        if (!entry.getName().equals(name)) {
          out.putNextEntry(new ZipEntry(entry.getName()));
          in.transferTo(out);
        }
      }
      out.putNextEntry(new ZipEntry(name));
      out.write(content);
    }
    Files.move(altered, jar, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
  }
}
