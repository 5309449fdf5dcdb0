package org.dfra.dist;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dfra.benchmarks.secure.BenchTeam;
import org.dfra.core.host.FreePorts;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * The processes of an installed robot start from the archive of classes that the first {@code dfra
 * up} writes in the background, and without it where it is broken, with nothing printed about it.
 */
@Timeout(300)
@EnabledOnOs(OS.LINUX) // the kernel says which files a process has mapped
class RobotArchiveIT {

  /** On a busy computer, the archive comes late: it is written with the lowest priority. */
  private static final Duration PATIENCE = Duration.ofSeconds(150);

  /** Some that no archive has, such as events of the flight recorder, and some seldom used ones. */
  private static final int MOST_OF_JDK = 100;

  @TempDir Path folder;

  @Test
  void aGroupStartsFromTheArchiveAndWithoutABrokenOne() throws Exception {
    try (Installation installed = new Installation(folder)) {
      Map<String, String> robot =
          Map.of(
              "DFRA_HOST",
              "127.0.0.1",
              "DFRA_ATRV1_REGISTRAR_PORT",
              Integer.toString(FreePorts.allocate()),
              "DFRA_ATRV1_CLASS_PORT",
              "off",
              "DFRA_ATRV1_GPS_FRONT_LINK",
              "tcp://127.0.0.1:" + FreePorts.allocate());
      Installation.Outcome up =
          installed.dfra(robot, "up", "--port=" + FreePorts.allocate(), "--registry-port=-1");
      assertThat(up.exit()).as(up.out() + up.err()).isZero();
      Path archive = awaitArchive(installed);
      assertThat(installed.dfra(robot, "doctor", "--team=").out())
          .contains("start from the archive " + archive);

      long restarted = kill(group(installed).orElseThrow(), installed);
      assertThat(maps(restarted)).as("files of the restarted group").contains(archive.toString());

      byte[] whole = Files.readAllBytes(archive);
      for (byte[] broken :
          List.of("no archive".getBytes(), Arrays.copyOf(whole, whole.length / 2))) {
        replace(archive, broken);
        restarted = kill(restarted, installed);
        assertThat(maps(restarted))
            .as("files of a group beside an archive of %s bytes", broken.length)
            .doesNotContain(archive.toString());
      }
      replace(archive, whole);
      restarted = kill(restarted, installed);
      assertThat(maps(restarted)).as("the whole one again").contains(archive.toString());

      assertThat(printed()).as("what the virtual machines printed").isEmpty();
      installed.dfra(robot, "down");

      assertThat(classesOfJdk(installed, robot))
          .as("classes of the JDK that a group of a member reads outside of the archive")
          .hasSizeLessThan(MOST_OF_JDK);
    }
  }

  /**
   * Joins a team and brings the robot up. Without a member's classes in the archive there are 1300:
   * of TLS, key stores and XML.
   */
  private List<String> classesOfJdk(Installation installed, Map<String, String> robot)
      throws Exception {
    try (BenchTeam team = BenchTeam.create(folder.resolve("authority"))) {
      Path unused = team.join(folder.resolve("state"), MemberRole.ROBOT, "atrv1");
    }
    Map<String, String> logged = new HashMap<>(robot);
    logged.put("JAVA_TOOL_OPTIONS", "-Xlog:class+load:file=" + folder.resolve("classes-%p.log"));
    Installation.Outcome up =
        installed.dfra(logged, "up", "--port=" + FreePorts.allocate(), "--registry-port=-1");
    assertThat(up.exit()).as(up.out() + up.err()).isZero();
    assertThat(installed.dfra(robot, "status").out()).contains("Secure:");
    Path log = folder.resolve("classes-" + group(installed).orElseThrow() + ".log");
    List<String> lines = Files.readAllLines(log);
    installed.dfra(robot, "down");
    assertThat(lines).as("classes of TLS").anyMatch(line -> line.contains(" sun.security.ssl."));
    return lines.stream().filter(line -> line.contains("source: jrt:/")).toList();
  }

  /** Waits until all archives are written and what wrote them has ended. */
  private Path awaitArchive(Installation installed) throws IOException {
    await().atMost(PATIENCE).until(() -> archive().isPresent());
    await()
        .atMost(PATIENCE)
        .untilAsserted(() -> assertThat(installed.living()).as("the robot's alone").hasSize(3));
    return archive().orElseThrow();
  }

  private Optional<Path> archive() throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(each -> each.getFileName().toString().matches("robot-\\d+-[0-9a-f]+\\.(jsa|aot)"))
          .findFirst();
    }
  }

  /** In one step: the group has the former one mapped. */
  private static void replace(Path archive, byte[] content) throws IOException {
    Path other = Files.write(archive.resolveSibling("other"), content);
    Files.move(other, archive, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }

  private static Optional<Long> group(Installation installed) {
    return installed.living().stream()
        .map(ProcessHandle::pid)
        .filter(pid -> read(pid, "cmdline").contains("org.dfra.group=atrv1.gps"))
        .findFirst();
  }

  /** The process that phoenix starts in its place, once it runs and uses the network. */
  private static long kill(long group, Installation installed) {
    ProcessHandle.of(group).orElseThrow().destroyForcibly();
    await()
        .atMost(PATIENCE)
        .until(
            () ->
                group(installed)
                    .filter(pid -> pid != group)
                    .filter(pid -> maps(pid).contains("libnet.so"))
                    .isPresent());
    return group(installed).orElseThrow();
  }

  private static String maps(long pid) {
    return read(pid, "maps");
  }

  private static String read(long pid, String file) {
    try {
      return Files.readString(Path.of("/proc", Long.toString(pid), file));
    } catch (IOException e) {
      return ""; // it has ended meanwhile
    }
  }

  private String printed() throws IOException {
    StringBuilder all = new StringBuilder();
    try (Stream<Path> files = Files.list(folder.resolve("state/output"))) {
      for (Path each : files.filter(file -> file.toString().contains(".vm.log")).toList()) {
        all.append(Files.readString(each));
      }
    }
    return all.toString();
  }
}
