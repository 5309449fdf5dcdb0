package org.dfra.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.RobotRemoval;
import org.dfra.robot.RunningPhoenix;
import org.dfra.testing.InteractiveProcess;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;

/**
 * Robots in real processes, under one phoenix, serve a kind of module that their clients have never
 * seen. Robot r1 is shared: it serves a jar that nobody has signed, and each test that needs it
 * finds it serving. The order of the tests only saves bringing it up again.
 *
 * <p>The short form rebuilds a served jar twice: once the module's process is restarted first, once
 * the registrar's. It leaves to {@code dfra.full} that both have been restarted.
 */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class RobotCodebaseIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final Duration PATIENCE = Duration.ofSeconds(40);
  private static final String ALL_IS_SERVED = "all is served";

  @TempDir private static Path folder;
  private static RunningPhoenix phoenix;

  /** The process that brings robots up, as {@code ./dfra up} with jars of its own beside DFRA's. */
  private static InteractiveProcess starter;

  private static Robot r1;

  /** A copy of what r1 serves, for those who do not download it. */
  private static Path elsewhere;

  /** Whether r1 is up and serves everything. */
  private static boolean isServed;

  /**
   * A robot with a laser scanner.
   *
   * @param dl where the jar is that it serves
   * @param port of its registrar
   * @param classPort of its class server
   */
  private record Robot(String name, Path dl, Path xml, int port, int classPort) {

    static Robot in(Path folder, String name) throws IOException {
      Path dl = Files.createDirectories(folder.resolve(name + "/kinds"));
      int port = FreePorts.allocate();
      int classPort = FreePorts.allocate();
      Path xml =
          Files.writeString(
              folder.resolve(name + "/" + name + ".xml"),
              """
              <robot xmlns="urn:dfra:robot:1" name="%s" host="127.0.0.1">
                <group name="lookup"><registrar port="%d" class-server-port="%d"/></group>
                <group name="lasers">
                  <module name="laser" server="sample.lidar.LidarServer"
                      proxy="sample.lidar.LidarProxy" implementation="sample.lidar.LidarImpl"
                      codebase="kinds/lidar-dl.jar"/>
                </group>
              </robot>
              """
                  .formatted(name, port, classPort));
      return new Robot(name, dl, xml, port, classPort);
    }

    Path kind() {
      return dl.resolve("lidar-dl.jar");
    }

    String found(String build) {
      return "found [" + build + ", 3, " + name + "/laser, READY]";
    }
  }

  @BeforeAll
  static void start() throws Exception {
    Path own = Files.createDirectories(folder.resolve("lib/dl"));
    for (String each : List.of("dfra-api", "dfra-client")) {
      Files.copy(DownloadJarTest.file(each), own.resolve(each + ".jar"));
    }
    r1 = Robot.in(folder, "r1");
    elsewhere = Files.copy(KindJar.lidar(r1.dl(), "unsigned"), folder.resolve("elsewhere.jar"));
    Path robots = KindJar.lidar(Files.createDirectory(folder.resolve("own")), "the robots' own");
    Path server = KindJar.lidarServer(folder, robots);
    phoenix = RunningPhoenix.start(folder.resolve("phoenix"));
    starter =
        Role.start(
            List.of(robots, server),
            List.of("-Ddfra.serial.allow=sample.lidar.*", "-Ddfra.lib=" + folder.resolve("lib")),
            "robot",
            phoenix.process().host(),
            Integer.toString(phoenix.process().port()),
            phoenix.process().state().toString());
    starter.awaitLine();
  }

  @AfterAll
  static void end() throws Exception {
    try (RunningPhoenix ended = phoenix;
        InteractiveProcess left = starter) {
      assertThat(ended != null && left != null).as("phoenix and the process beside").isTrue();
    }
  }

  /** Brings a robot up, and answers what that says of its class server. */
  private static String up(Robot robot) throws Exception {
    try {
      return starter.request(robot.xml().toString());
    } finally {
      phoenix.note();
    }
  }

  /** Robot r1 as it is at first, also where a test has left it otherwise. */
  private static void awaitServed() throws Exception {
    if (!isServed) {
      removeR1();
      assertThat(up(r1)).isEqualTo(ALL_IS_SERVED);
      isServed = true;
    }
  }

  private static void removeR1() throws Exception {
    isServed = false;
    RobotRemoval.removeRobot(phoenix.process(), r1.name(), PATIENCE);
    if (!Files.exists(r1.kind())) {
      Path unused = Files.copy(elsewhere, r1.kind());
    }
  }

  @Test
  @Order(2)
  void everyClientContinuesWhicheverProcessIsRestartedFirstAfterARebuild() throws Exception {
    Robot r2 = Robot.in(folder, "r2");
    Path team = KindJar.key(folder, "team");
    KindJar.sign(KindJar.lidar(r2.dl(), "first"), team);
    String trust = "trust.store = " + team + "\ntrust.store.password = " + KindJar.PASSWORD + "\n";
    try (InteractiveProcess client = client("old", trust)) {
      assertThat(up(r2)).isEqualTo(ALL_IS_SERVED);
      awaitAnswer(client, r2, "first");

      KindJar.sign(KindJar.lidar(r2.dl(), "second"), team);
      phoenix.kill("r2.lasers"); // the class server lives on, and has never read this jar
      assertThat(client.request("again"))
          .as("what it has, from a new process")
          .isEqualTo(r2.found("first"));
      awaitAnswer(client, r2, "second");
      onlyANewClientGets(r2, "second", trust);

      KindJar.sign(KindJar.lidar(r2.dl(), "third"), team);
      phoenix.kill("r2.lookup"); // the module's group lives on, and names the jar of before
      assertThat(client.request("again")).isEqualTo(r2.found("second"));
      onlyANewClientGets(r2, "second", trust);

      if (FULL) {
        phoenix.kill("r2.lasers");
        awaitAnswer(client, r2, "third");
        onlyANewClientGets(r2, "third", trust);
      }
    } finally {
      RobotRemoval.removeRobot(phoenix.process(), r2.name(), PATIENCE);
    }
  }

  @Test
  @Order(2)
  void aClientThatPinsTheKindsOwnJarNeedsToTrustNoOther() throws Exception {
    awaitServed();
    onlyANewClientGets(r1, "unsigned", pinned());
    try (InteractiveProcess distrustful = client("distrustful", "")) {
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(distrustful.request(Integer.toString(r1.port())))
                      .startsWith("refused: ")
                      .contains("/lidar-dl.jar;sha-256=")
                      .contains("its digest is not pinned"));
    }
  }

  @Test
  @Order(2)
  void aModuleWhoseClassesAreRefusedIsListedWithTheRemedyAndNoLogLine() throws Exception {
    awaitServed();
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

  /** What {@code ./dfra module list} says on both of its outputs. */
  private String moduleList() throws Exception {
    List<String> command =
        new ArrayList<>(InteractiveProcess.java(System.getProperty("java.class.path"), List.of()));
    command.addAll(List.of("org.dfra.cli.Main", "module", "list", "--team=", "--wait=20"));
    command.addAll(
        List.of("--locator=127.0.0.1:" + r1.port(), "--state=" + folder.resolve("nobody's")));
    Process list = new ProcessBuilder(command).redirectErrorStream(true).start();
    list.getOutputStream().close();
    String printed = new String(list.getInputStream().readAllBytes());
    assertThat(list.waitFor()).as(printed).isZero();
    return printed;
  }

  @Test
  @Order(1) // it leaves r1 as the others need it
  void aRobotWhoseClassPortIsTakenWorksAndServesWhenItIsFree() throws Exception {
    removeR1();
    ServerSocket taken = new ServerSocket(r1.classPort(), 5, InetAddress.getByName(Role.HOST));
    try (InteractiveProcess client = client("patient", pinned())) {
      assertThat(up(r1))
          .startsWith("clients that lack lidar-dl.jar cannot download it from 127.0.0.1:")
          .endsWith("; see the registrar group's log");
      assertThat(log("lookup"))
          .contains("the class server cannot listen on 127.0.0.1:" + r1.classPort())
          .contains("trying again every 5 s");
      taken.close();
      awaitAnswer(client, r1, "unsigned");
      assertThat(up(r1)).isEqualTo(ALL_IS_SERVED);
      isServed = true;
    } finally {
      taken.close();
    }
  }

  @Test
  @Order(3) // it leaves r1 without its jar
  void aGroupWhoseJarIsGoneWhenItStartsWorksForThoseWhoHaveTheClasses() throws Exception {
    awaitServed();
    isServed = false;
    Files.delete(r1.kind());
    phoenix.kill("r1.lasers");
    try (InteractiveProcess client =
        Role.start(List.of(elsewhere), List.of("-Ddfra.serial.allow=sample.lidar.*"), "client")) {
      client.awaitLine();
      awaitAnswer(client, r1, "unsigned");
    }
    assertThat(log("lasers"))
        .contains(
            "Clients cannot download [%1$s]: the jar %1$s cannot be served".formatted(r1.kind()))
        .contains("build it first");
  }

  /** The security manager, without which River downloads nothing, ended with Java 24. */
  @Test
  @Order(2)
  @EnabledForJreRange(max = JRE.JAVA_23)
  void aClientThatHasOnlyRiverDownloadsTheProxyAndTheTransport() throws Exception {
    int port = FreePorts.allocate();
    Path xml =
        Files.writeString(
            folder.resolve("r3.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="r3" host="127.0.0.1">
              <group name="lookup"><registrar port="%d" class-server-port="%d"/></group>
              <group name="receivers">
                <module name="gps" server="org.dfra.river.server.sensor.GPSServer"
                    proxy="org.dfra.river.proxy.sensor.GPSProxy" implementation="%s"/>
              </group>
            </robot>
            """
                .formatted(port, FreePorts.allocate(), StillReceiverImpl.class.getName()));
    try (InteractiveProcess client = riverClient()) {
      assertThat(starter.request(xml.toString())).isEqualTo(ALL_IS_SERVED);
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(client.request(Integer.toString(port)))
                      .as(client.output())
                      .contains("latitude=48.5", "frame=r3/gps")
                      .contains("/dfra-api.jar;sha-256=", "/dfra-client.jar;sha-256=")
                      .contains(" by dfra-watchdog"));
    } finally {
      phoenix.note();
      RobotRemoval.removeRobot(phoenix.process(), "r3", PATIENCE);
    }
  }

  /** Its class path has River's jars and one class. */
  private static InteractiveProcess riverClient() throws Exception {
    Path own = folder.resolve("river-client");
    String file = RiverClient.class.getName().replace('.', '/') + ".class";
    Files.createDirectories(own.resolve(file).getParent());
    try (InputStream in = RiverClient.class.getResourceAsStream("/" + file)) {
      Files.copy(in, own.resolve(file));
    }
    Path policy =
        Files.writeString(
            folder.resolve("all.policy"), "grant { permission java.security.AllPermission; };\n");
    String classPath =
        Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
            .filter(each -> Path.of(each).getFileName().toString().matches("(jsk|reggie)-.*\\.jar"))
            .collect(Collectors.joining(File.pathSeparator, own + File.pathSeparator, ""));
    List<String> command =
        new ArrayList<>(
            InteractiveProcess.java(
                classPath,
                List.of(
                    "-Djava.security.manager",
                    "-Djava.security.policy=" + policy,
                    "-Djava.rmi.server.useCodebaseOnly=false",
                    "-Djava.protocol.handler.pkgs=net.jini.url")));
    command.add(RiverClient.class.getName());
    return new InteractiveProcess(command);
  }

  /** Those that kept running may have what they need; this one has nothing. */
  private static void onlyANewClientGets(Robot robot, String build, String trust) throws Exception {
    try (InteractiveProcess client = client("new", trust)) {
      awaitAnswer(client, robot, build);
    }
  }

  private static void awaitAnswer(InteractiveProcess client, Robot robot, String build) {
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThat(client.request(Integer.toString(robot.port())))
                    .isEqualTo(robot.found(build)));
  }

  private static InteractiveProcess client(String name, String trust) throws Exception {
    Path file = Files.writeString(folder.resolve(name + ".properties"), trust);
    InteractiveProcess client = Role.start(List.of(), List.of("-Ddfra.trust=" + file), "client");
    client.awaitLine();
    return client;
  }

  private static String log(String group) throws IOException {
    return Files.readString(Path.of(phoenix.group("r1." + group).output()));
  }

  /** What a client trusts that pins the jar of r1. */
  private static String pinned() throws Exception {
    return "pinned.lidar = " + sha256(r1.kind()) + "\n";
  }

  private static String sha256(Path file) throws Exception {
    return HexFormat.of()
        .formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file)));
  }
}
