package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.zip.CRC32;
import org.dfra.core.lease.SteppedScheduler;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.flow.effector.EmergencyStopState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

class EmergencyStopLatchTest {

  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00.123456Z");

  @TempDir Path folder;

  private final SteppedScheduler time = new SteppedScheduler();
  private Instant wall = NOW;

  private EmergencyStopLatch latch() {
    return latch(StateStore.inFolder(folder));
  }

  private EmergencyStopLatch latch(StateStore state) {
    return latch(state, BootId.system());
  }

  private EmergencyStopLatch latch(StateStore state, BootId boot) {
    return new EmergencyStopLatch(
        "atrv1/drive", state, () -> wall, time, boot, LoggerFactory.getLogger("dfra.atrv1.drive"));
  }

  @Test
  void anEffectorThatWasNeverStoppedIsFree() {
    assertThat(latch().state()).isEqualTo(EmergencyStopState.NEVER);
    assertThat(folder).as("reading writes nothing").isEmptyDirectory();
  }

  @Test
  void isLatchedInEveryLifeUntilItIsReleased() {
    EmergencyStopLatch first = latch();
    assertThat(first.engage("ops at 192.0.2.7")).isTrue();
    assertThat(first.engage("another")).as("it is latched already").isFalse();
    assertThat(first.persist()).isTrue();
    EmergencyStopLatch second = latch();
    assertThat(second.state())
        .isEqualTo(
            new EmergencyStopState(
                true, "ops at 192.0.2.7", Instant.parse("2026-11-21T12:00:00.123Z"), true, null));
    assertThat(latch().state()).as("of the third life").isEqualTo(second.state());
    assertThat(second.release("the chief")).isTrue();
    assertThat(second.release("another")).isFalse();
    assertThat(second.persist()).isTrue();
    EmergencyStopState kept = EmergencyStopLatch.loadState(StateStore.inFolder(folder));
    assertThat(kept.latched()).isFalse();
    assertThat(kept.requester()).isEqualTo("the chief");
  }

  @Test
  void reportsHowLongAgoItWasWhateverIsDoneToTheClock() throws Exception {
    StateStore state = StateStore.inMemory();
    BootId boot = boot("one");
    EmergencyStopLatch first = latch(state, boot);
    assertThat(first.state().age()).as("of one that was never stopped").isNull();
    first.engage("ops");
    first.persist();
    time.step(Duration.ofSeconds(3));
    wall = wall.minus(Duration.ofHours(1));
    assertThat(first.state().age()).isEqualTo(Duration.ofSeconds(3));
    time.step(Duration.ofSeconds(4));
    wall = wall.plus(Duration.ofDays(300));
    EmergencyStopLatch second = latch(state, boot);
    assertThat(second.state().age()).as("in the next life").isEqualTo(Duration.ofSeconds(7));
    second.release("ops");
    assertThat(second.state().age()).as("of the release").isZero();
    assertThat(EmergencyStopLatch.loadState(state).age()).as("where no effector lives").isNull();
  }

  @Test
  void afterAnotherBootItIsKnownToBeAsOldAsThisLifeAtLeast() throws Exception {
    StateStore state = StateStore.inMemory();
    EmergencyStopLatch first = latch(state, boot("one"));
    first.engage("ops");
    first.persist();
    EmergencyStopLatch unknown = latch(state, new BootId(folder.resolve("none")));
    time.step(Duration.ofSeconds(2));
    assertThat(unknown.state().age()).isEqualTo(Duration.ofSeconds(2));
    assertThat(unknown.state()).isEqualTo(first.state());
  }

  /** Version 0.1 wrote no monotonic time. */
  @Test
  void readsWhatAnEarlierVersionKept() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeInt(0x44464501);
    out.writeBoolean(true);
    out.writeLong(NOW.toEpochMilli());
    out.writeUTF("ops");
    CRC32 sum = new CRC32();
    sum.update(bytes.toByteArray());
    out.writeLong(sum.getValue());
    StateStore state = StateStore.inMemory();
    state.write("stop", bytes.toByteArray());
    EmergencyStopState kept = latch(state, boot("one")).state();
    assertThat(kept.requester()).isEqualTo("ops");
    assertThat(kept.fault()).isNull();
    assertThat(kept.age()).isZero();
  }

  private BootId boot(String name) throws IOException {
    return new BootId(Files.writeString(folder.resolve(name), name));
  }

  @Test
  void whateverIsTornOrGarbledIsLatched() throws Exception {
    EmergencyStopLatch free = latch();
    free.engage("ops");
    free.release("ops"); // the bytes of one that is free: damage must not keep them so
    free.persist();
    byte[] whole = Files.readAllBytes(folder.resolve("stop"));
    assertThat(latch().isLatched()).isFalse();
    for (int length = 0; length < whole.length; length++) {
      assertTakenToBeLatched(Arrays.copyOf(whole, length), length + " bytes of it");
    }
    assertTakenToBeLatched(Arrays.copyOf(whole, whole.length + 1), "one byte too many");
    for (int bit = 0; bit < whole.length * 8; bit++) {
      byte[] flipped = whole.clone();
      flipped[bit / 8] ^= (byte) (1 << bit % 8);
      assertTakenToBeLatched(flipped, "bit " + bit + " flipped");
    }
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 200; i++) {
      byte[] garbage = new byte[random.nextInt(100)];
      random.nextBytes(garbage);
      assertTakenToBeLatched(garbage, "-Ddfra.seed=" + seed + ", round " + i);
    }
    assertTakenToBeLatched("latched=false\n".getBytes(StandardCharsets.UTF_8), "another form");
  }

  private void assertTakenToBeLatched(byte[] content, String what) throws IOException {
    Files.write(folder.resolve("stop"), content);
    EmergencyStopState state = latch().state();
    assertThat(state.latched()).as(what).isTrue();
    assertThat(state.requester()).as(what).isNull();
    assertThat(state.fault())
        .as(what)
        .isEqualTo(
            "what is kept of its emergency stop in "
                + folder
                + " is damaged, so it is taken to be stopped");
    assertThat(latch().refusalMessage())
        .isEqualTo(
            "atrv1/drive is stopped for an emergency since an unknown time, and executes no"
                + " commands; when it is safe, release it: ./dfra stop --release atrv1");
  }

  @Test
  void oneThatIsDamagedIsWholeAgainOnceItIsStoppedOrReleased() throws Exception {
    Files.write(folder.resolve("stop"), new byte[3]);
    EmergencyStopLatch latch = latch();
    assertThat(latch.engage("ops")).as("nobody knows who latched it").isTrue();
    latch.persist();
    assertThat(latch().state().requester()).isEqualTo("ops");
    Files.write(folder.resolve("stop"), new byte[3]);
    EmergencyStopLatch again = latch();
    assertThat(again.release("ops")).isTrue();
    again.persist();
    assertThat(latch().isLatched()).isFalse();
  }

  @Test
  void whatCannotBeReadIsLatched() throws Exception {
    Files.createDirectory(folder.resolve("stop")); // unreadable to root, too
    EmergencyStopState state = latch().state();
    assertThat(state.latched()).isTrue();
    assertThat(state.fault()).contains("cannot be read (").endsWith("it is taken to be stopped");
  }

  @Test
  void isLatchedInMemoryWhereItCannotBeWritten() {
    FullDisk disk = new FullDisk();
    EmergencyStopLatch latch = latch(disk);
    latch.engage("ops");
    assertThat(latch.persist()).isFalse();
    assertThat(latch.isLatched()).isTrue();
    assertThat(latch.state().fault())
        .isEqualTo(
            "it cannot be written to a full disk (java.io.IOException: No space left on device),"
                + " so the module would not know of it after a restart");
    disk.full = false;
    assertThat(latch.persist()).isTrue();
    assertThat(latch.state().fault()).isNull();
    assertThat(latch(disk).isLatched()).isTrue();
  }

  @Test
  void theRequesterIsOneShortLine() {
    EmergencyStopLatch latch = latch();
    latch.engage(" ops\r\n\u0007root ");
    assertThat(latch.state().requester()).isEqualTo("ops root");
    latch.release("\t");
    assertThat(latch.state().requester()).isEqualTo("somebody");
    latch.engage("é".repeat(100_000));
    assertThat(latch.state().requester()).hasSize(121).endsWith("é…");
    latch.persist();
    assertThat(latch().state()).isEqualTo(latch.state());
  }

  @Test
  void isLatchedAndReleasedAlsoWhereNobodyIsNamed() {
    EmergencyStopLatch latch = latch();
    assertThat(latch.engage(null)).isTrue();
    assertThat(latch.state().requester()).isEqualTo("somebody");
    assertThat(latch.persist()).isTrue();
    assertThat(latch().isLatched()).as("of the next life").isTrue();
    assertThat(latch.release(null)).isTrue();
    assertThat(latch.isLatched()).isFalse();
  }

  /** Remembers, until it is full. */
  static final class FullDisk implements StateStore {

    private final StateStore memory = StateStore.inMemory();
    volatile boolean full = true;

    @Override
    public Optional<byte[]> read(String name) throws IOException {
      return memory.read(name);
    }

    @Override
    public void write(String name, byte[] content) throws IOException {
      if (full) {
        throw new IOException("No space left on device");
      }
      memory.write(name, content);
    }

    @Override
    public Counters counters(String name, int count) throws IOException {
      return memory.counters(name, count);
    }

    @Override
    public String toString() {
      return "a full disk";
    }
  }
}
