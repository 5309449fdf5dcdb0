package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.UnknownGroupException;
import java.rmi.server.UID;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import java.util.stream.Stream;
import org.dfra.core.host.PrivateFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.io.TempDirFactory;

/** What is on the disk, after everything that may happen to it. */
class JournalTest {

  private static final int NEVER = 1_000_000;

  @TempDir(factory = InMemory.class)
  Path temp;

  private final ActivationGroupID group = new ActivationGroupID(null);

  @Test
  void committedChangeSurvivesWithoutClosing() throws Exception {
    Path folder = temp.resolve("journal");
    Journal journal = Journal.open(folder, NEVER);
    journal.commit(registered("robot"));
    UID object = new UID();
    journal.commit(new JournalRecord.ObjectRegistered(object, desc("a.B")));
    ProcessIdentity process = new ProcessIdentity(4711, "tick 1 of boot x");
    journal.commit(new JournalRecord.Launching(group, 7));
    journal.commit(new JournalRecord.Launched(group, process));

    try (Journal next = Journal.open(copy(folder), NEVER)) {
      assertThat(next.<String>read(r -> r.group(group).name)).isEqualTo("robot");
      assertThat(next.<Long>read(r -> r.group(group).incarnation)).isEqualTo(7);
      assertThat(next.<ProcessIdentity>read(r -> r.group(group).process)).isEqualTo(process);
      assertThat(next.<ActivationDesc>read(r -> r.objects.get(object))).isEqualTo(desc("a.B"));
    }
    journal.close();
  }

  @Test
  void changesSurviveTheirSnapshots() throws Exception {
    List<UID> objects = new ArrayList<>();
    try (Journal journal = Journal.open(temp, 3)) {
      journal.commit(registered("robot"));
      for (int i = 0; i < 20; i++) {
        objects.add(new UID());
        journal.commit(new JournalRecord.ObjectRegistered(objects.get(i), desc("object " + i)));
      }
      journal.commit(new JournalRecord.ObjectUnregistered(objects.remove(4), 0));
    }
    try (Journal next = Journal.open(temp, 3)) {
      assertThat(next.<List<UID>>read(r -> List.copyOf(r.objects.keySet()))).isEqualTo(objects);
    }
  }

  @Test
  void whatWasUnregisteredWhileAProcessHadItIsKnownUntilTheNextProcess() throws Exception {
    UID ended = new UID();
    UID left = new UID();
    UID former = new UID();
    try (Journal journal = Journal.open(temp, 4)) {
      journal.commit(registered("robot"));
      for (UID each : List.of(ended, left, former)) {
        journal.commit(new JournalRecord.ObjectRegistered(each, desc("a.B")));
      }
      journal.commit(new JournalRecord.Launching(group, 7));
      journal.commit(new JournalRecord.ObjectUnregistered(ended, 7));
      journal.commit(new JournalRecord.ObjectUnregistered(left, 7));
      journal.commit(new JournalRecord.ObjectUnregistered(former, 6));
      journal.commit(new JournalRecord.UnregisteredEnded(group, ended));
    }
    try (Journal next = Journal.open(temp, NEVER)) {
      assertThat(next.<Set<UID>>read(r -> Set.copyOf(r.group(group).unregistered())))
          .containsExactly(left);
      next.commit(new JournalRecord.Launching(group, 8));
      assertThat(next.<Set<UID>>read(r -> Set.copyOf(r.group(group).unregistered()))).isEmpty();
    }
  }

  @Test
  void failedCommitHasNotHappenedAndTheNextOneWorks() throws Exception {
    try (Journal journal = Journal.open(temp, NEVER)) {
      journal.commit(registered("first"));
      Properties unwritable = new Properties();
      unwritable.put("a stream", System.out);
      assertThatExceptionOfType(ActivationException.class)
          .isThrownBy(
              () ->
                  journal.commit(
                      new JournalRecord.GroupDescribed(
                          group, new ActivationGroupDesc(unwritable, null))))
          .withMessageContaining("has not happened");
      assertThat(journal.<Object>read(r -> r.group(group).desc.getPropertyOverrides())).isNull();
      try (Journal onDisk = Journal.open(copy(temp), NEVER)) {
        assertThat(onDisk.<Object>read(r -> r.group(group).desc.getPropertyOverrides())).isNull();
      }
      UID later = new UID();
      journal.commit(new JournalRecord.ObjectRegistered(later, desc("later")));
      try (Journal onDisk = Journal.open(copy(temp), NEVER)) {
        assertThat(onDisk.<Boolean>read(r -> r.objects.containsKey(later))).isTrue();
      }
    }
  }

  @Test
  void changeOfAnUnregisteredGroupIsRefusedAndSpoilsNothing() throws Exception {
    try (Journal journal = Journal.open(temp, NEVER)) {
      journal.commit(registered("short-lived"));
      journal.commit(new JournalRecord.GroupUnregistered(group));
      for (JournalRecord each :
          List.of(
              new JournalRecord.Launching(group, 1),
              new JournalRecord.Launched(group, new ProcessIdentity(1, "")),
              new JournalRecord.Left(group),
              new JournalRecord.GroupDescribed(group, new ActivationGroupDesc(null, null)),
              new JournalRecord.GroupUnregistered(group),
              new JournalRecord.ObjectRegistered(new UID(), desc("a.B")))) {
        assertThatExceptionOfType(UnknownGroupException.class)
            .as("%s", each)
            .isThrownBy(() -> journal.commit(each));
      }
    }
    Journal.open(temp, NEVER).close();
  }

  @Test
  void lastRecordTornAtAnyByteIsDroppedAndNothingElse() throws Exception {
    Path folder = temp.resolve("journal");
    UID kept = new UID();
    long before;
    try (Journal journal = Journal.open(folder, NEVER)) {
      journal.commit(registered("robot"));
      journal.commit(new JournalRecord.ObjectRegistered(kept, desc("kept")));
      before = Files.size(log(folder));
      journal.commit(new JournalRecord.ObjectRegistered(new UID(), desc("torn")));
    }
    byte[] whole = Files.readAllBytes(log(folder));
    int end = whole.length - 4; // the zero length of a record to come
    for (int length = (int) before; length < end; length++) {
      // As a disk may leave it: cut off, or as long as it should be with zeros where data was due.
      assertKept(folder, java.util.Arrays.copyOf(whole, length), kept, length);
      byte[] zeros = java.util.Arrays.copyOf(java.util.Arrays.copyOf(whole, length), whole.length);
      if (!java.util.Arrays.equals(zeros, whole)) {
        assertKept(folder, zeros, kept, length);
      }
    }
  }

  private void assertKept(Path folder, byte[] log, UID kept, int length) throws IOException {
    Path torn = copy(folder);
    Files.write(log(torn), log);
    try (Journal journal = Journal.open(torn, NEVER)) {
      List<UID> objects = journal.read(r -> List.copyOf(r.objects.keySet()));
      assertThat(objects).as("objects, last record torn after byte %s", length).startsWith(kept);
      // Where only padding was missing the record is whole, and counts.
      if (objects.size() > 1) {
        assertThat(journal.<ActivationDesc>read(r -> r.objects.get(objects.get(1))))
            .as("last record torn after byte %s", length)
            .isEqualTo(desc("torn"));
        assertThat(objects).hasSize(2);
      }
    }
  }

  @Test
  void damagedRecordThatOthersFollowIsRefusedWhereverTheDamageIs() throws Exception {
    Path folder = temp.resolve("journal");
    int from;
    int to;
    try (Journal journal = Journal.open(folder, NEVER)) {
      journal.commit(registered("robot"));
      from = (int) Files.size(log(folder)) - 4;
      journal.commit(new JournalRecord.ObjectRegistered(new UID(), desc("damaged")));
      to = (int) Files.size(log(folder)) - 4;
      journal.commit(new JournalRecord.ObjectRegistered(new UID(), desc("acknowledged")));
    }
    byte[] whole = Files.readAllBytes(log(folder));
    int length = ByteBuffer.wrap(whole).getInt(from);
    for (int at = from; at < Math.min(to, from + 4 + length); at++) {
      Path damaged = copy(folder);
      byte[] bytes = whole.clone();
      bytes[at] ^= 0x41;
      Files.write(log(damaged), bytes);
      assertThatExceptionOfType(IOException.class)
          .as("byte %s of the log changed", at)
          .isThrownBy(() -> Journal.open(damaged, NEVER).close())
          .withMessageContaining("The journal in " + damaged + " cannot be used")
          .withMessageContaining("record 2 is damaged and others follow it")
          .withMessageContaining("restore it from a backup");
      assertThat(Files.readAllBytes(log(damaged))).as("the log afterwards").isEqualTo(bytes);
    }
  }

  @Test
  void damagedSnapshotIsRefused() throws Exception {
    Journal.open(temp, NEVER).close();
    Path snapshot = file(temp, "Snapshot.");
    byte[] bytes = Files.readAllBytes(snapshot);
    bytes[bytes.length / 2] ^= 1;
    Files.write(snapshot, bytes);
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> Journal.open(temp, NEVER).close())
        .withMessageContaining("the snapshot is damaged");
  }

  @Test
  void lostVersionFileIsNoNewJournal() throws Exception {
    try (Journal journal = Journal.open(temp, NEVER)) {
      journal.commit(registered("robot"));
    }
    Files.write(temp.resolve("Version_Number"), new byte[2]);
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> Journal.open(temp, NEVER).close())
        .withMessageContaining("its version file is missing or damaged");
  }

  @Test
  void secondDaemonOnTheSameJournalIsRefusedAndHarmsNothing() throws Exception {
    try (Journal journal = Journal.open(temp, NEVER)) {
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> Journal.open(temp, NEVER).close())
          .withMessageContaining(
              "process %d of user %s still owns this journal",
              ProcessHandle.current().pid(), PrivateFiles.user().getName());
      journal.commit(registered("robot"));
    }
    try (Journal next = Journal.open(temp, NEVER)) {
      assertThat(next.<Integer>read(r -> r.groups.size())).isEqualTo(1);
    }
  }

  private JournalRecord registered(String name) {
    return new JournalRecord.GroupRegistered(group, name, new ActivationGroupDesc(null, null));
  }

  private ActivationDesc desc(String className) {
    return new ActivationDesc(group, className, null, null);
  }

  private static Path log(Path folder) throws IOException {
    return file(folder, "Logfile.");
  }

  private static Path file(Path folder, String prefix) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> file.getFileName().toString().startsWith(prefix))
          .findFirst()
          .orElseThrow();
    }
  }

  /** Thousands of syncs cost minutes on a busy disk, and what is tried here is not the disk. */
  static final class InMemory implements TempDirFactory {
    @Override
    public Path createTempDirectory(AnnotatedElementContext element, ExtensionContext extension)
        throws IOException {
      Path memory = Path.of("/dev/shm");
      return Files.isWritable(memory)
          ? Files.createTempDirectory(memory, "journal")
          : Files.createTempDirectory("journal");
    }
  }

  private int copies;

  /** What a daemon would find that starts now. */
  private Path copy(Path folder) throws IOException {
    Path copy = Files.createDirectories(temp.resolve("copy" + copies++));
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Files.copy(file, copy.resolve(file.getFileName()));
      }
    }
    return copy;
  }
}
