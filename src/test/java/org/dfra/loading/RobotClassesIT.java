package org.dfra.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.dfra.core.host.FreePorts;
import org.dfra.robot.LivingPhoenix;
import org.dfra.testing.TalkingProcess;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A robot in real processes serves a kind of module that its clients have never seen. */
class RobotClassesIT {

  private static final Duration PATIENCE = Duration.ofSeconds(40);
  private static final String ALL_IS_SERVED = "all is served";

  @TempDir private Path folder;
  private Path dl;
  private LivingPhoenix phoenix;
  private int port;
  private int classPort;

  @BeforeEach
  void start() throws Exception {
    dl = Files.createDirectories(folder.resolve("kinds"));
    Path own = Files.createDirectories(folder.resolve("lib/dl"));
    Files.copy(DownloadJarTest.file(), own.resolve("dfra-river-dl.jar"));
    phoenix = LivingPhoenix.start(folder.resolve("phoenix"));
    port = FreePorts.next();
    classPort = FreePorts.next();
  }

  @AfterEach
  void end() throws IOException {
    phoenix.close();
  }

  @Test
  void whoeverIsRestartedFirstAfterARebuildEveryClientGoesOn() throws Exception {
    Path team = KindJar.key(folder, "team");
    Path own = KindJar.lidar(Files.createDirectory(folder.resolve("own")), "the robot's own");
    KindJar.sign(KindJar.lidar(dl, "first"), team);
    String trust = "trust.store = " + team + "\ntrust.store.password = " + KindJar.PASSWORD + "\n";
    try (TalkingProcess robot = robot(own);
        TalkingProcess client = client("old", trust)) {
      assertThat(robot.ask("up")).isEqualTo(ALL_IS_SERVED);
      awaitAnswer(client, "first");

      KindJar.sign(KindJar.lidar(dl, "second"), team);
      phoenix.kill("r1.lasers"); // the class server lives on, and has never read this jar
      assertThat(client.ask("again"))
          .as("what it has, from a new process")
          .isEqualTo(found("first"));
      awaitAnswer(client, "second");
      onlyANewClientGets("second", trust);

      KindJar.sign(KindJar.lidar(dl, "third"), team);
      phoenix.kill("r1.lookup"); // the module's group lives on, and names the jar of before
      assertThat(client.ask("again")).isEqualTo(found("second"));
      onlyANewClientGets("second", trust);

      phoenix.kill("r1.lasers");
      awaitAnswer(client, "third");
      onlyANewClientGets("third", trust);
    }
  }

  @Test
  void aClientThatPinsTheKindsOwnJarNeedsToTrustNoOther() throws Exception {
    Path kind = KindJar.lidar(dl, "pinned"); // signed by nobody
    String pinned = "pinned.lidar = " + sha256(kind) + "\n";
    try (TalkingProcess robot = robot(kind)) {
      assertThat(robot.ask("up")).isEqualTo(ALL_IS_SERVED);
      onlyANewClientGets("pinned", pinned);
      try (TalkingProcess distrustful = client("distrustful", "")) {
        await()
            .atMost(PATIENCE)
            .untilAsserted(
                () ->
                    assertThat(distrustful.ask(Integer.toString(port)))
                        .startsWith("refused: ")
                        .contains("/lidar-dl.jar;sha-256=")
                        .contains("its digest is not pinned"));
      }
    }
  }

  @Test
  void aModuleWhoseClassesAreRefusedIsListedWithTheRemedyAndNoLogLine() throws Exception {
    Path kind = KindJar.lidar(dl, "refused"); // signed by nobody
    try (TalkingProcess robot = robot(kind)) {
      assertThat(robot.ask("up")).isEqualTo(ALL_IS_SERVED);
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(moduleList())
                      .containsPattern("(?m)^r1/laser +refused +0 +127\\.0\\.0\\.1 +now$")
                      .contains("r1/laser cannot be used here: codebase http")
                      .contains("its digest is not pinned", "or pin the digest.\n")
                      .doesNotContain("WARN"));
    }
  }

  /** What {@code ./dfra module list} says on both of its outputs. */
  private String moduleList() throws Exception {
    List<String> command =
        new ArrayList<>(TalkingProcess.java(System.getProperty("java.class.path"), List.of()));
    command.addAll(List.of("org.dfra.app.Main", "module", "list", "--team=", "--wait=20"));
    command.addAll(List.of("--locator=127.0.0.1:" + port, "--state=" + folder.resolve("nobody's")));
    Process list = new ProcessBuilder(command).redirectErrorStream(true).start();
    list.getOutputStream().close();
    String said = new String(list.getInputStream().readAllBytes());
    assertThat(list.waitFor()).as(said).isZero();
    return said;
  }

  @Test
  void aRobotWhoseClassPortIsTakenWorksAndServesWhenItIsFree() throws Exception {
    Path kind = KindJar.lidar(dl, "patient");
    ServerSocket taken = new ServerSocket(classPort, 5, InetAddress.getByName(Role.HOST));
    try (TalkingProcess robot = robot(kind);
        TalkingProcess client = client("patient", "pinned.lidar = " + sha256(kind) + "\n")) {
      assertThat(robot.ask("up"))
          .startsWith("clients that lack lidar-dl.jar cannot download it from 127.0.0.1:")
          .endsWith("; see the registrar group's log");
      assertThat(log("lookup"))
          .contains("the class server cannot listen on 127.0.0.1:" + classPort)
          .contains("trying again every 5 s");
      taken.close();
      awaitAnswer(client, "patient");
      assertThat(robot.ask("up")).isEqualTo(ALL_IS_SERVED);
    } finally {
      taken.close();
    }
  }

  @Test
  void aGroupWhoseJarIsGoneWhenItStartsWorksForThoseWhoHaveTheClasses() throws Exception {
    Path kind = KindJar.lidar(dl, "gone");
    Path elsewhere = Files.copy(kind, folder.resolve("elsewhere.jar"));
    try (TalkingProcess robot = robot(elsewhere)) {
      assertThat(robot.ask("up")).isEqualTo(ALL_IS_SERVED);
      Files.delete(kind);
      phoenix.kill("r1.lasers");
      try (TalkingProcess client =
          Role.start(List.of(elsewhere), List.of("-Ddfra.serial.allow=sample.lidar.*"), "client")) {
        client.awaitLine();
        awaitAnswer(client, "gone");
      }
      assertThat(log("lasers"))
          .contains("Clients cannot download [" + kind + "]: the jar " + kind + " cannot be served")
          .contains("build it first");
    }
  }

  /** Those that kept running may have what they need; this one has nothing. */
  private void onlyANewClientGets(String build, String trust) throws Exception {
    try (TalkingProcess client = client("new", trust)) {
      awaitAnswer(client, build);
    }
  }

  private void awaitAnswer(TalkingProcess client, String build) {
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () -> assertThat(client.ask(Integer.toString(port))).isEqualTo(found(build)));
  }

  private static String found(String build) {
    return "found [" + build + ", 3, r1/laser, READY]";
  }

  /** The process that brings robot r1 up, as {@code ./dfra up} with these jars beside DFRA's. */
  private TalkingProcess robot(Path onClassPath) throws Exception {
    Path server = KindJar.lidarServer(folder, onClassPath);
    Path xml =
        Files.writeString(
            folder.resolve("r1.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="r1" host="127.0.0.1">
              <group name="lookup"><registrar port="%d" classes="%d"/></group>
              <group name="lasers">
                <module name="laser" server="sample.lidar.LidarServer"
                    proxy="sample.lidar.LidarProxy" driver="sample.lidar.LidarImpl"
                    download="kinds/lidar-dl.jar"/>
              </group>
            </robot>
            """
                .formatted(port, classPort));
    TalkingProcess robot =
        Role.start(
            List.of(onClassPath, server),
            List.of("-Ddfra.serial.allow=sample.lidar.*", "-Ddfra.lib=" + folder.resolve("lib")),
            "robot",
            phoenix.process().host(),
            Integer.toString(phoenix.process().port()),
            phoenix.process().state().toString(),
            xml.toString());
    robot.awaitLine();
    return robot;
  }

  private TalkingProcess client(String name, String trust) throws Exception {
    Path file = Files.writeString(folder.resolve(name + ".properties"), trust);
    TalkingProcess client = Role.start(List.of(), List.of("-Ddfra.trust=" + file), "client");
    client.awaitLine();
    return client;
  }

  private String log(String group) throws IOException {
    return Files.readString(Path.of(phoenix.group("r1." + group).output()));
  }

  private static String sha256(Path file) throws Exception {
    return HexFormat.of()
        .formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file)));
  }
}
