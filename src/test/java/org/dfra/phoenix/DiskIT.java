package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.dfra.river.phoenix.GroupStatus.State;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A full disk and a damaged journal: one clear sentence each, and nothing acknowledged lost.
 *
 * <p>{@code dfra.full} starts phoenix twice more: after space was freed while it ran, and with a
 * damaged snapshot.
 */
class DiskIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");

  @TempDir Path temp;

  @Test
  void fullDiskRefusesChangesAndLosesNothingAcknowledged() throws Exception {
    Path disk = Files.createDirectory(temp.resolve("disk"));
    assumeThat(run("mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", disk.toString()))
        .as(
            "mounting a small tmpfs needs root; without it %s",
            "the limit of a file's size has to do")
        .isZero();
    try (PhoenixFixture phoenix =
        new PhoenixFixture(temp).journalIn(disk.resolve("journal")).start()) {
      ActivationGroupID group = phoenix.group("disk");
      Beacon beacon = phoenix.beacon(group, "ok " + phoenix.device("disk"), false);
      Set<ActivationID> acknowledged = fill(phoenix, group, disk.toString());
      assertThat(beacon.pid()).as("the group serves").isPositive();
      assertThat(phoenix.admin().getActivatableObjects(group).keySet())
          .as("what phoenix knows while the disk is full")
          .containsAll(acknowledged);
      // Killed while the disk is full, phoenix cannot begin, and says why.
      phoenix.kill();
      fillRest(disk);
      assertThat(phoenix.startInVain())
          .contains("Phoenix cannot start: The journal in " + disk)
          .contains("No space left on device")
          .contains("Free space");
      assertThat(run("mount", "-o", "remount,size=8m", disk.toString())).isZero();
      phoenix.start();
      assertThat(phoenix.admin().getActivatableObjects(group).keySet())
          .as("after space was freed")
          .containsAll(acknowledged);
      register(phoenix, group);
      assertThat(beacon.pid()).isPositive();
    } finally {
      run("umount", "-l", disk.toString());
    }
  }

  @Test
  void spaceFreedWhilePhoenixRunsIsUsedAgain() throws Exception {
    Path disk = Files.createDirectory(temp.resolve("disk"));
    assumeThat(run("mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", disk.toString()))
        .as("mounting a small tmpfs needs root")
        .isZero();
    try (PhoenixFixture phoenix =
        new PhoenixFixture(temp).journalIn(disk.resolve("journal")).start()) {
      ActivationGroupID group = phoenix.group("disk");
      ActivationID object = phoenix.register(group, "ok " + phoenix.device("disk"), false);
      Beacon leaver = phoenix.beacon(phoenix.group("leaver"), "ok", false);
      long leaving = leaver.pid();
      Set<ActivationID> acknowledged = fill(phoenix, group, disk.toString());
      leaver.deactivate();
      PhoenixFixture.awaitDeath(leaving);
      assertThat(phoenix.awaitStatus("leaver", s -> s.state() == State.IDLE).totalCrashes())
          .as("crashes of a group that ended while nothing could be recorded")
          .isZero();
      assertThatExceptionOfType(ActivationException.class)
          .as("a launch that cannot be recorded")
          .isThrownBy(() -> object.activate(false))
          .withMessageContaining("could not record the change")
          .satisfies(e -> assertThat(e.getMessage()).doesNotContain("correct its command"));
      assertThat(run("mount", "-o", "remount,size=8m", disk.toString())).isZero();
      acknowledged.add(register(phoenix, group));
      assertThat(((Beacon) object.activate(false)).pid()).isPositive();
      if (FULL) { // every day the other tests do so
        phoenix.kill();
        phoenix.start();
      }
      assertThat(phoenix.admin().getActivatableObjects(group).keySet()).containsAll(acknowledged);
    } finally {
      run("umount", "-l", disk.toString());
    }
  }

  /** Works without root: no file of phoenix's may grow beyond 64 blocks of 1 KB (bash). */
  @Test
  void fileThatMayNotGrowIsReportedLikeAFullDisk() throws Exception {
    try (PhoenixFixture phoenix =
        new PhoenixFixture(temp)
            .by("bash", "-c", "trap '' XFSZ; ulimit -f 64; exec \"$@\"", "limit")
            .start()) {
      ActivationGroupID group = phoenix.group("limit");
      Set<ActivationID> acknowledged = fill(phoenix, group, phoenix.journal().toString());
      phoenix.kill();
      phoenix.by();
      phoenix.start();
      assertThat(phoenix.admin().getActivatableObjects(group).keySet())
          .as("after the limit was lifted")
          .containsAll(acknowledged);
      register(phoenix, group);
    }
  }

  private static Set<ActivationID> fill(
      PhoenixFixture phoenix, ActivationGroupID group, String place) throws Exception {
    List<ActivationID> acknowledged = new ArrayList<>();
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(
            () -> {
              while (acknowledged.size() < 2000) {
                acknowledged.add(register(phoenix, group));
              }
            })
        .withMessageContaining("phoenix could not record the change in " + place)
        .withMessageContaining("so it has not happened; free space there and try again")
        .satisfies(
            e ->
                assertThat(e.getMessage())
                    .containsAnyOf("No space left on device", "File too large"));
    assertThat(acknowledged).isNotEmpty();
    return new java.util.HashSet<>(acknowledged);
  }

  private static ActivationID register(PhoenixFixture phoenix, ActivationGroupID group)
      throws Exception {
    return phoenix
        .system()
        .registerObject(
            new ActivationDesc(
                group,
                BeaconImpl.class.getName(),
                null,
                new MarshalledObject<>("ok " + "x".repeat(4000)),
                false));
  }

  private static void fillRest(Path disk) throws IOException {
    try (OutputStream out = Files.newOutputStream(disk.resolve("rest"))) {
      while (true) {
        out.write(new byte[512]);
      }
    } catch (IOException e) {
      assertThat(e).hasMessageContaining("No space");
    }
  }

  private static int run(String... command) throws Exception {
    try {
      Process process =
          new ProcessBuilder(command)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      return process.waitFor();
    } catch (IOException e) {
      return -1; // no such command
    }
  }

  @Test
  void damagedJournalIsReportedInOneSentenceAndNotTouched() throws Exception {
    try (PhoenixFixture phoenix = new PhoenixFixture(temp).start()) {
      ActivationGroupID group = phoenix.group("damage");
      for (int i = 0; i < 3; i++) {
        phoenix.register(group, "ok", false);
      }
      phoenix.kill();
      Path log = file(phoenix.journal(), "Logfile.");
      byte[] good = Files.readAllBytes(log);
      byte[] bad = good.clone();
      bad[bad.length / 2] ^= 1;
      Files.write(log, bad);
      assertThat(phoenix.startInVain())
          .contains("Phoenix cannot start: The journal in " + phoenix.journal())
          .contains("is damaged and others follow it");
      assertThat(Files.readAllBytes(log)).as("the damaged log afterwards").isEqualTo(bad);

      Files.write(log, good);
      if (FULL) { // every day JournalTest damages a snapshot
        Path snapshot = file(phoenix.journal(), "Snapshot.");
        byte[] whole = Files.readAllBytes(snapshot);
        Files.write(snapshot, java.util.Arrays.copyOf(whole, whole.length / 2));
        assertThat(phoenix.startInVain()).contains("the snapshot is damaged");
        Files.write(snapshot, whole);
      }
      Files.write(log, java.util.Arrays.copyOf(good, good.length - 30));
      phoenix.start();
      assertThat(phoenix.output()).contains("was torn; it was never acknowledged and is dropped");
      assertThat(phoenix.admin().getActivatableObjects(group)).hasSize(2);
    }
  }

  private static Path file(Path folder, String prefix) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> file.getFileName().toString().startsWith(prefix))
          .findFirst()
          .orElseThrow();
    }
  }
}
