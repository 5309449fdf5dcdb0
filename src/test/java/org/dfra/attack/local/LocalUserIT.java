package org.dfra.attack.local;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.UUID;
import java.util.stream.Stream;
import org.dfra.benchmarks.attack.OtherUser;
import org.dfra.benchmarks.attack.StrangersGroup;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.robot.RunningPhoenix;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a user without rights can do to the robot on whose computer it runs programs: nothing. */
class LocalUserIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final String GROUP = "local.lookup";

  @TempDir static Path temp;
  private static OtherUser nobody;
  private static RunningPhoenix phoenix;

  /** Where {@code nobody} may write. */
  private static Path everybodys;

  @BeforeAll
  static void start() throws Exception {
    nobody =
        OtherUser.find(Files.createDirectory(temp.resolve("classes")))
            .orElseGet(() -> abort("needs " + OtherUser.NEEDS));
    everybodys = Files.createDirectory(temp.resolve("everybody"));
    Files.setPosixFilePermissions(everybodys, PosixFilePermissions.fromString("rwxrwxrwx"));
    phoenix = RunningPhoenix.start(temp.resolve("state"));
    Path xml =
        Files.writeString(
            temp.resolve("robot.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="local" host="127.0.0.1">
              <group name="lookup"><registrar port="%d" class-server-port="off"/></group>
            </robot>
            """
                .formatted(FreePorts.allocate()));
    List<RobotBootstrap.ServiceReference> unused =
        new RobotBootstrap(phoenix.process(), RobotXml.read(xml)).up();
  }

  @AfterAll
  static void end() throws Exception {
    if (phoenix != null) {
      phoenix.close();
    }
  }

  @Test
  void registersNoGroupUnderAnyIdentityThatItCanKnow() throws Exception {
    List<String> known = new ArrayList<>();
    StrangersGroup.KNOWN.forEach(each -> known.add(each.toString()));
    known.add(UUID.randomUUID().toString());
    Path marker = everybodys.resolve("ran");
    try (TaskProcess attack = register(marker, known)) {
      attack.awaitLine("done", PATIENCE);
      assertThat(attack.lines()).filteredOn(line -> line.startsWith("silent ")).hasSize(4);
      assertThat(attack.lines()).filteredOn(line -> line.startsWith("refused ")).hasSize(4);
    }
    assertThat(marker).as("what the attacker's program makes").doesNotExist();
    assertThat(phoenix.process().admin().groupStatus()).hasSize(1);
  }

  /** Shows that the attack reaches a phoenix whose identity it has, and that this is not enough. */
  @Test
  void registersNoGroupWithAClassPathOfItsOwnEvenIfTheIdentityWereKnown() throws Exception {
    Path marker = everybodys.resolve("ran with the identity");
    try (TaskProcess attack = register(marker, List.of(secret("system")))) {
      attack.awaitLine("answered 1 groups", PATIENCE);
      assertThat(attack.awaitLine("refused ", PATIENCE))
          .contains("class path " + everybodys + " of a group without a name is not permitted");
    }
    assertThat(marker).as("what the attacker's program makes").doesNotExist();
  }

  private static TaskProcess register(Path marker, List<String> identities) throws IOException {
    List<String> arguments =
        new ArrayList<>(List.of(port(), everybodys.toString(), marker.toString()));
    arguments.addAll(identities);
    return nobody.start(RegisterOwnGroup.class, arguments.toArray(String[]::new));
  }

  private static String port() {
    return Integer.toString(phoenix.process().port());
  }

  private static String secret(String service) throws IOException {
    Properties lines = new Properties();
    try (var in = Files.newInputStream(phoenix.process().state().resolve("journal/identity"))) {
      lines.load(in);
    }
    return lines.getProperty(service);
  }

  @Test
  void commandOfAnotherUserSaysWhosePhoenixItIs() throws Exception {
    Path state = phoenix.process().state();
    try (TaskProcess command = nobody.start(AskPhoenix.class, port(), state.toString())) {
      assertThat(command.awaitLine("", PATIENCE))
          .isEqualTo(
              "failed the phoenix on port %s belongs to user %s; its identity file %s cannot be"
                  + " read; run the command as that user",
              port(), Files.getOwner(state).getName(), state.resolve("journal/identity"));
    }
    Path own = Files.createDirectory(everybodys.resolve("own"));
    try (TaskProcess command = nobody.start(AskPhoenix.class, port(), own.toString())) {
      assertThat(command.awaitLine("failed ", PATIENCE))
          .contains("is held by a process of user " + Files.getOwner(state).getName());
    }
  }

  @Test
  void takesNoLockAndAKilledGroupRestarts() throws Exception {
    GroupStatus before = phoenix.group(GROUP);
    Path journal = phoenix.process().state().resolve("journal");
    Path lock = journal.resolve(before.name() + ".lock");
    assertThat(lock).exists();
    Path free = Files.writeString(everybodys.resolve("free.lock"), "");
    try (TaskProcess thief =
        nobody.start(
            TakeLocks.class,
            free.toString(),
            lock.toString(),
            journal.resolve("phoenix.lock").toString(),
            journal.resolve("identity").toString())) {
      thief.awaitLine("done", PATIENCE);
      assertThat(thief.lines())
          .contains("holds " + free) // so it can take what it can read
          .filteredOn(line -> line.startsWith("cannot "))
          .hasSize(3)
          .allMatch(line -> line.endsWith(" AccessDeniedException"));
      phoenix.kill(GROUP);
      await("group " + GROUP + " in another process")
          .atMost(PATIENCE)
          .until(
              () -> phoenix.group(GROUP),
              now -> now.state() == GroupStatus.State.ACTIVE && now.pid() != before.pid());
      assertThat(thief.isAlive()).as("the thief kept trying").isTrue();
    }
  }

  @Test
  void commandLinesGiveNoIdentityAway() throws Exception {
    List<Long> processes =
        List.of(phoenix.process().pid().orElseThrow(), phoenix.group(GROUP).pid());
    for (long pid : processes) {
      assertThat(
              Files.readString(
                  Path.of("/proc", Long.toString(pid), "cmdline"), StandardCharsets.UTF_8))
          .as("what every user may read of process %d", pid)
          .contains("org.dfra.river.phoenix")
          .doesNotContain(secret("system"))
          .doesNotContain(secret("monitor"));
    }
  }

  @Test
  void nothingOfTheStateFolderCanBeReached() throws Exception {
    Path state = phoenix.process().state();
    assertThat(mode(state)).isEqualTo("rwx------");
    assertThat(mode(state.resolve("journal"))).isEqualTo("rwx------");
    List<Path> files = new ArrayList<>();
    for (Path each : List.of(state, state.resolve("journal"), state.resolve("output"))) {
      try (Stream<Path> all = Files.list(each)) {
        files.addAll(
            all.filter(file -> file.toString().matches(".*(\\.lock|\\.log|/identity)")).toList());
      }
    }
    assertThat(files)
        .hasSizeGreaterThan(4)
        .allSatisfy(file -> assertThat(mode(file)).as("%s", file).isEqualTo("rw-------"));
  }

  private static String mode(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }
}
