package org.dfra.dist;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dfra.core.host.FreePorts;
import org.dfra.dist.Installation.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code ./dfra dist}: a robot is brought up from what was unpacked, where nothing can compile. */
class DistIT {

  /**
   * 12.22 MB when this was written; without budgets, facts, stops' own lane, calls on behalf and
   * the review of leases it was 12.01 MB. Without identities, TLS, policies and the audit trail it
   * was 11.97 MB; with tables of local variables in the main classes it would be 12.38 MB.
   */
  private static final long MOST_BYTES = 12_300_000;

  @TempDir Path folder;

  @Test
  void aRobotIsBroughtUpAndDownFromWhatWasUnpacked() throws Exception {
    Map<String, String> robot =
        Map.of(
            "DFRA_HOST",
            "127.0.0.1",
            "DFRA_TEAM",
            "dist-" + UUID.randomUUID(),
            "DFRA_WAIT",
            "20",
            "DFRA_ATRV1_REGISTRAR_PORT",
            Integer.toString(FreePorts.allocate()),
            "DFRA_ATRV1_CLASS_PORT",
            Integer.toString(FreePorts.allocate()),
            // Nobody answers there: the module is up all the same, and goes on trying.
            "DFRA_ATRV1_GPS_FRONT_LINK",
            "tcp://127.0.0.1:" + FreePorts.allocate());
    try (Installation installed = new Installation(folder)) {
      assertThat(installed.dfra(robot, "--version").out()).startsWith("dfra ");
      assertThat(installed.dfra(robot, "help").out())
          .contains("up ", "doctor ")
          .doesNotContain("by the script itself", "./dfra ");
      assertThat(installed.dfra(robot, "module", "remove", "--help").out())
          .contains("the next dfra up starts it again");

      Outcome demo = installed.dfra(robot, "demo", "raster", "--speed=2");
      assertThat(demo.exit()).isEqualTo(69);
      assertThat(demo.err()).isEqualTo("dfra: demo is in dfra-examples, which is not installed\n");

      String multicopter = installed.home() + "/config/teams/recruit/uav.xml";
      Outcome flying = installed.dfra(robot, "up", multicopter);
      assertThat(flying.exit()).isEqualTo(1);
      assertThat(flying.err())
          .contains(
              ": module uav/flight: driver class org.dfra.drivers.uav.mavlink.MavlinkFlightImpl is"
                  + " in dfra-flight, which is not installed; \"dist --flight\" packs it\n");

      Outcome early = installed.dfra(robot, "status");
      assertThat(early.exit()).isEqualTo(4);
      assertThat(early.err()).contains("bring a robot up first: dfra up ROBOT.XML");

      Outcome up =
          installed.dfra(robot, "up", "--port=" + FreePorts.allocate(), "--registry-port=-1");
      assertThat(up.exit()).as(up.out() + up.err()).isZero();
      assertThat(up.out())
          .contains("Up: atrv1/registrar in group lookup.", "Up: atrv1/gps_front in group gps.")
          .contains("How they are: dfra status");
      await()
          .atMost(Duration.ofSeconds(150))
          .untilAsserted(
              () ->
                  assertThat(installed.living())
                      .as("phoenix and two groups; what wrote archives of classes has ended")
                      .hasSize(3));
      String pid = Files.readString(folder.resolve("state/phoenix.pid")).strip();
      assertThat(up.out()).contains("Started phoenix: process " + pid + ",");

      assertThat(installed.dfra(robot, "module", "list", "--team=").out())
          .containsPattern("atrv1/gps_front +GPSSensor");

      Outcome doctor = installed.dfra(robot, "doctor", "--team=");
      assertThat(doctor.exit()).as(doctor.out() + doctor.err()).isZero();
      assertThat(doctor.out()).contains(" at " + installed.java(), installed.home() + "/lib/boot/");

      assertThat(installed.dfra(robot, "--version").out().lines().findFirst())
          .as("the version that the build wrote into the jar")
          .contains(installed.home().getFileName().toString().replaceFirst("-", " "));

      Path loaded = folder.resolve("loaded.txt");
      Map<String, String> logged = new HashMap<>(robot);
      logged.put("DFRA_OPTIONS", "-Xlog:class+load:file=" + loaded);
      Outcome stop = installed.dfra(logged, "stop", "--all", "--team=");
      assertThat(loaded)
          .as("up has archived the classes, and commands have them from there")
          .content()
          .contains("org.dfra.cli.stop.StopCommand source: shared objects file (top)");
      assertThat(stop.exit()).as("it has no effector: %s", stop.out() + stop.err()).isEqualTo(3);

      Outcome down = installed.dfra(robot, "down");
      assertThat(down.exit()).as(down.out() + down.err()).isZero();
      await()
          .atMost(Duration.ofSeconds(20))
          .untilAsserted(() -> assertThat(installed.living()).isEmpty());
    }
  }

  @Test
  void theSameJarsGiveTheSameBytesWhateverClassesAreArchivedAmongThem() throws Exception {
    Path one = Installation.pack(folder.resolve("one"));
    Path lib = folder.resolve("lib");
    Installation.run(Map.of(), "cp", "-R", BuiltJars.assumed().lib().toString(), lib.toString());
    Files.writeString(Files.createDirectory(lib.resolve("archive")).resolve("17.jsa"), "classes");
    Path other = Installation.pack(lib, folder.resolve("other"));
    assertThat(Files.mismatch(one, other)).as("first byte that differs").isEqualTo(-1);
    String listed =
        Installation.run(Map.of("TZ", "UTC"), "tar", "--numeric-owner", "-tvzf", one.toString())
            .out();
    assertThat(listed.lines())
        .allSatisfy(line -> assertThat(line).contains(" 0/0 "))
        .anyMatch(line -> line.startsWith("-rwxr-xr-x") && line.endsWith("/bin/dfra"))
        .anyMatch(line -> line.endsWith("/lib/dfra-cli.jar"))
        .anyMatch(line -> line.endsWith("/lib/boot/dfra-activation.jar"))
        .anyMatch(line -> line.endsWith("/lib/dl/dfra-client.jar"))
        .anyMatch(line -> line.endsWith("/config/robots/atrv1.xml"))
        .anyMatch(line -> line.endsWith("/config/fuzzy/waypoint.fis"))
        .noneMatch(line -> line.contains("VectorGraphics2D")) // under the LGPL
        .anyMatch(line -> line.endsWith("/docs/troubleshooting.md"))
        .anyMatch(line -> line.endsWith("/systemd/dfra.service"))
        .anyMatch(line -> line.endsWith("/README.md"));
    try (var left = Files.list(one.getParent())) {
      assertThat(left).as("nothing else is left").containsExactly(one);
    }
  }

  /** What draws, simulates and measures stays where robots are developed. */
  @Test
  void aRobotHasTheVerbsAndWhatTheyNeed() throws Exception {
    Path tarball = Installation.pack(folder.resolve("out"));
    Path unpacked = Files.createDirectory(folder.resolve("unpacked"));
    Installation.run(Map.of(), "tar", "-xzf", tarball.toString(), "-C", unpacked.toString());
    String name = tarball.getFileName().toString().replace(".tar.gz", "");
    try (Stream<Path> lib = Files.list(unpacked.resolve(name).resolve("lib"))) {
      List<Path> jars = lib.filter(each -> each.toString().endsWith(".jar")).toList();
      assertThat(jars.stream().map(each -> each.getFileName().toString()))
          .contains("dfra-cli.jar", "dfra-report.jar", "dfra-drivers.jar", "dfra-recruit.jar")
          .contains("dfra-client.jar", "dfra-phoenix.jar", "dfra-river.jar")
          .noneMatch(
              each ->
                  each.matches(
                      "dfra-(authority|flight|examples|experiments|benchmarks|sim|testing|fixtures)\\.jar"))
          .noneMatch(
              each ->
                  each.matches(
                      "(bcpkix|bcprov|bcutil|mavlink|xchart|batik|commons|jeromq|jmh|jnacl|jopt)-.*"));
      long bytes = 0;
      for (Path each : jars) {
        bytes += Files.size(each);
      }
      assertThat(bytes).as("bytes of the jars").isLessThanOrEqualTo(MOST_BYTES);
      assertThat(librariesOf(jars)).isEqualTo(librariesInNotice());
    }
  }

  /** The names in NOTICE of the libraries that the jars are of; of an unknown jar, its own name. */
  private static Set<String> librariesOf(List<Path> jars) {
    Map<String, String> names = new LinkedHashMap<>();
    names.put("(jsk-|reggie).*", "Apache River");
    names.put("ejml-.*", "EJML");
    names.put("jackson-.*", "Jackson");
    names.put("jdom2-.*", "JDOM");
    names.put("jSerialComm-.*", "jSerialComm");
    names.put("jts-.*", "JTS Topology Suite");
    names.put("logback-.*", "Logback");
    names.put("picocli-.*", "picocli");
    names.put("(jul-to-)?slf4j.*", "SLF4J");
    Set<String> libraries = new TreeSet<>();
    for (Path each : jars) {
      String jar = each.getFileName().toString();
      if (!jar.startsWith("dfra-")) {
        libraries.add(
            names.entrySet().stream()
                .filter(name -> jar.matches(name.getKey()))
                .map(Map.Entry::getValue)
                .findFirst()
                .orElse(jar));
      }
    }
    return libraries;
  }

  /** The libraries in the first table of NOTICE, which is of what is installed on a robot. */
  private static Set<String> librariesInNotice() throws IOException {
    Pattern row = Pattern.compile("  (\\S+(?: \\S+)*) {2,}\\S.*"); // not its continuation
    Set<String> libraries = new TreeSet<>();
    boolean inTable = false;
    for (String line : Files.readAllLines(Path.of(System.getProperty("dfra.root"), "NOTICE"))) {
      Matcher found = row.matcher(line);
      if (line.startsWith("  library ")) {
        inTable = true;
      } else if (inTable && line.isEmpty()) {
        break;
      } else if (inTable && found.matches()) {
        libraries.add(found.group(1).strip());
      }
    }
    return libraries;
  }

  @Test
  void systemdUnderstandsTheUnit() throws Exception {
    assumeTrue(
        Arrays.stream(System.getenv("PATH").split(":"))
            .anyMatch(each -> Files.isExecutable(Path.of(each, "systemd-analyze"))),
        "systemd-analyze is not installed here");
    Path command = Files.writeString(folder.resolve("dfra"), "#!/bin/sh\n");
    assertThat(command.toFile().setExecutable(true)).isTrue();
    Path root = Path.of(System.getProperty("dfra.root"));
    String unit = Files.readString(root.resolve("src/dist/systemd/dfra.service"));
    Path here =
        Files.writeString(
            folder.resolve("dfra.service"), unit.replace("/opt/dfra/bin/dfra", command.toString()));
    Outcome verified =
        Installation.start(Map.of(), "systemd-analyze", "verify", "--man=no", here.toString());
    assertThat(verified.out() + verified.err())
        .as("what it says of this unit")
        .doesNotContain("dfra.service");
    assertThat(verified.exit()).as(verified.err()).isZero();
  }
}
