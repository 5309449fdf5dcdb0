package org.dfra.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dfra.testing.InteractiveProcess;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TrustedCodeIT {

  @TempDir private static Path shared;
  private static Path team;
  private static Path stranger;
  private static Path evil;
  private static InteractiveProcess registrar;
  private static @Nullable InteractiveProcess refusing;
  private static String port;

  @TempDir private Path folder;

  @BeforeAll
  static void startRegistrar() throws Exception {
    team = KindJar.key(shared, "team");
    stranger = KindJar.key(shared, "stranger");
    evil = KindJar.lidar(shared, "evil");
    Path configuration = shared.resolve("reggie.config");
    Files.writeString(
        configuration,
        """
        import net.jini.jeri.BasicJeriExporter;
        import org.dfra.river.call.Endpoints;
        import org.dfra.river.call.DeadlineILFactory;
        com.sun.jini.reggie {
          serverExporter = new BasicJeriExporter(
              Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(5000L), false, true);
          serverSocketFactory = Endpoints.serverSocketFactory("127.0.0.1");
          unicastDiscoveryHost = "127.0.0.1";
          initialUnicastDiscoveryPort = 0;
          multicastInterfaces = new java.net.NetworkInterface[] {};
        }
        """);
    registrar = Role.start(List.of(), List.of(), "registrar", configuration.toString());
    port = registrar.awaitLine();
  }

  @AfterAll
  static void stopProcesses() throws Exception {
    try (InteractiveProcess one = registrar;
        InteractiveProcess other = refusing) {
      assertThat(one).as("the registrar").isNotNull();
    }
  }

  /** One client for whatever must not be loaded; what it says of it, and logs of it alone. */
  private static void assertRefused(String port, String... sentences) throws Exception {
    InteractiveProcess client = refusing;
    if (client == null) {
      client = client(shared);
      refusing = client;
    }
    int before = client.output().length();
    assertThat(client.request(port)).startsWith("refused: ").contains(sentences);
    assertThat(marker(shared)).doesNotExist();
    String logged = client.output().substring(before);
    assertThat(logged).as("the log tells the operator").contains("WARN");
  }

  @Test
  void aKindTheClientHasNeverSeenIsUsedAndAfterItIsRebuiltTheNewOne() throws Exception {
    Path jar = KindJar.sign(KindJar.lidar(folder, "first"), team);
    try (InteractiveProcess client = client(folder)) {
      String classPort;
      try (InteractiveProcess server = server(jar, "0", "honest")) {
        classPort = server.awaitLine();
        assertThat(client.request(port)).isEqualTo("found [first, 3, atrv1/lidar, READY]");
        assertThat(client.request(port)).isEqualTo("found [first, 3, atrv1/lidar, READY]");
      }
      jar = KindJar.sign(KindJar.lidar(folder, "second"), team);
      try (InteractiveProcess server = server(jar, classPort, "honest")) {
        assertThat(server.awaitLine()).as("the same port").isEqualTo(classPort);
        assertThat(client.request(port)).isEqualTo("found [second, 3, atrv1/lidar, READY]");
      }
      assertThat(client.output()).contains("it is signed by a trusted key");
      assertThat(marker(folder)).as("so its absence elsewhere says something").exists();
    }
  }

  @ParameterizedTest
  @CsvSource({
    "stranger, honest, 'is signed by CN=stranger, whose key is not trusted here'",
    "nobody, honest, 'the jar is not signed, and its digest alone says nothing of who made it'",
    "team, tampered, 'what is served there has SHA-256 '",
    "team, http, 'http: is not accepted, only httpmd: with a sha-256 digest'"
  })
  void aCorrectUrlOfAStrangersJarLoadsNothing(String signer, String lie, String why)
      throws Exception {
    Path jar = Files.copy(evil, folder.resolve(evil.getFileName()));
    if (!signer.equals("nobody")) {
      KindJar.sign(jar, signer.equals("team") ? team : stranger);
    }
    try (InteractiveProcess server = server(jar, "0", lie)) {
      server.awaitLine();
      assertRefused(port, "sample.lidar.LidarProxy was not loaded: codebase http", why);
    }
  }

  @Test
  void aHostileRegistrarLoadsNothing() throws Exception {
    Path jar = KindJar.registrar(folder);
    try (InteractiveProcess hostile =
        Role.start(List.of(jar), List.of(), "hostile", folder.toString())) {
      assertRefused(
          hostile.awaitLine(),
          "sample.evil.Registrar was not loaded: codebase httpmd://",
          "the jar is not signed");
    }
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "two processes")
  void theMarkerIsWrittenWhereTheCodeIsTrusted() throws Exception {
    Path jar = KindJar.sign(KindJar.lidar(folder, "trusted"), team);
    try (InteractiveProcess server = server(jar, "0", "honest");
        InteractiveProcess client = client(folder)) {
      server.awaitLine();
      assertThat(client.request(port)).startsWith("found [trusted");
      assertThat(marker(folder)).as("so its absence elsewhere says something").exists();
    }
  }

  private InteractiveProcess server(Path jar, String classPort, String lie) throws IOException {
    return Role.start(
        List.of(jar), List.of(), "server", port, classPort, jar.getParent().toString(), lie);
  }

  /**
   * A client that trusts the team's key.
   *
   * @param own its folder, where code that runs in it leaves its mark
   */
  private static InteractiveProcess client(Path own) throws Exception {
    Path trust = own.resolve("trust.properties");
    Files.writeString(
        trust, "trust.store = " + team + "\ntrust.store.password = " + KindJar.PASSWORD + "\n");
    InteractiveProcess client =
        Role.start(
            List.of(), List.of("-Ddfra.trust=" + trust, "-Dmarker=" + marker(own)), "client");
    client.awaitLine();
    return client;
  }

  private static Path marker(Path own) {
    return own.resolve("marker");
  }
}
