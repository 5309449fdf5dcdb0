package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.StopState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

class StopLatchTest {

  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00.123456Z");

  @TempDir Path folder;

  private StopLatch latch() {
    return latch(StateStore.in(folder));
  }

  private static StopLatch latch(StateStore state) {
    return new StopLatch(
        "atrv1/drive",
        state,
        InstantSource.fixed(NOW),
        LoggerFactory.getLogger("dfra.atrv1.drive"));
  }

  @Test
  void anEffectorThatWasNeverStoppedIsFree() {
    assertThat(latch().state()).isEqualTo(StopState.NEVER);
    assertThat(folder).as("reading writes nothing").isEmptyDirectory();
  }

  @Test
  void isLatchedInEveryLifeUntilItIsReleased() {
    StopLatch first = latch();
    assertThat(first.engage("ops at 192.0.2.7")).isTrue();
    assertThat(first.engage("another")).as("it is latched already").isFalse();
    assertThat(first.keep()).isTrue();
    StopLatch second = latch();
    assertThat(second.state())
        .isEqualTo(
            new StopState(
                true, "ops at 192.0.2.7", Instant.parse("2026-11-21T12:00:00.123Z"), true, null));
    assertThat(latch().state()).as("of the third life").isEqualTo(second.state());
    assertThat(second.release("the chief")).isTrue();
    assertThat(second.release("another")).isFalse();
    assertThat(second.keep()).isTrue();
    StopState kept = StopLatch.kept(StateStore.in(folder));
    assertThat(kept.latched()).isFalse();
    assertThat(kept.by()).isEqualTo("the chief");
  }

  @Test
  void whateverIsTornOrGarbledIsLatched() throws Exception {
    StopLatch free = latch();
    free.engage("ops");
    free.release("ops"); // the bytes of one that is free: damage must not keep them so
    free.keep();
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
    StopState state = latch().state();
    assertThat(state.latched()).as(what).isTrue();
    assertThat(state.by()).as(what).isNull();
    assertThat(state.fault())
        .as(what)
        .isEqualTo(
            "what is kept of its emergency stop in "
                + folder
                + " is damaged, so it is taken to be stopped");
    assertThat(latch().refusal())
        .isEqualTo(
            "atrv1/drive is stopped for an emergency since a time not known, and obeys nobody; when"
                + " it is safe, release it: ./dfra stop --release atrv1");
  }

  @Test
  void oneThatIsDamagedIsWholeAgainOnceItIsStoppedOrReleased() throws Exception {
    Files.write(folder.resolve("stop"), new byte[3]);
    StopLatch latch = latch();
    assertThat(latch.engage("ops")).as("nobody knows who latched it").isTrue();
    latch.keep();
    assertThat(latch().state().by()).isEqualTo("ops");
    Files.write(folder.resolve("stop"), new byte[3]);
    StopLatch again = latch();
    assertThat(again.release("ops")).isTrue();
    again.keep();
    assertThat(latch().isLatched()).isFalse();
  }

  @Test
  void whatCannotBeReadIsLatched() throws Exception {
    Files.createDirectory(folder.resolve("stop")); // unreadable to root, too
    StopState state = latch().state();
    assertThat(state.latched()).isTrue();
    assertThat(state.fault()).contains("cannot be read (").endsWith("it is taken to be stopped");
  }

  @Test
  void isLatchedInMemoryWhereItCannotBeWritten() {
    FullDisk disk = new FullDisk();
    StopLatch latch = latch(disk);
    latch.engage("ops");
    assertThat(latch.keep()).isFalse();
    assertThat(latch.isLatched()).isTrue();
    assertThat(latch.state().fault())
        .isEqualTo(
            "it cannot be written to a full disk (java.io.IOException: No space left on device), so"
                + " the next life of this module would not know of it");
    disk.full = false;
    assertThat(latch.keep()).isTrue();
    assertThat(latch.state().fault()).isNull();
    assertThat(latch(disk).isLatched()).isTrue();
  }

  @Test
  void whoAsksIsOneShortLine() {
    StopLatch latch = latch();
    latch.engage(" ops\r\n\u0007root ");
    assertThat(latch.state().by()).isEqualTo("ops root");
    latch.release("\t");
    assertThat(latch.state().by()).isEqualTo("somebody");
    latch.engage("é".repeat(100_000));
    assertThat(latch.state().by()).hasSize(121).endsWith("é…");
    latch.keep();
    assertThat(latch().state()).isEqualTo(latch.state());
  }

  @Test
  void isLatchedAndReleasedAlsoWhereNobodyIsNamed() {
    StopLatch latch = latch();
    assertThat(latch.engage(null)).isTrue();
    assertThat(latch.state().by()).isEqualTo("somebody");
    assertThat(latch.keep()).isTrue();
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
