package org.dfra.river.security.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The position that the processes of a robot share. */
class SharedPositionTest {

  private static final GeoPosition HERE = new GeoPosition(27.98, -82.45, 14);
  private static final GeoPosition THERE = new GeoPosition(28, -82, 0);
  private static final int BOOT = 16;

  @TempDir private Path folder;

  private final AtomicLong nanos = new AtomicLong(Long.MAX_VALUE - 10); // it will overflow
  private Path file;
  private SharedPosition writer;
  private SharedPosition reader;

  @BeforeEach
  void open() throws IOException {
    file = folder.resolve("position");
    writer = SharedPosition.open(file, nanos::get);
    reader = SharedPosition.open(file, nanos::get);
  }

  @AfterEach
  void close() throws IOException {
    writer.close();
    reader.close();
  }

  @Test
  void aPositionIsKnownForTwoSeconds() throws IOException {
    assertThat(reader.read()).isEmpty();
    writer.write(1, HERE);
    nanos.addAndGet(SharedPosition.MAX_AGE_NANOS);
    assertThat(reader.read()).contains(HERE);
    nanos.addAndGet(1);
    assertThat(reader.read()).isEmpty();
  }

  @Test
  void aBetterSourceCountsAsLongAsItIsFresh() throws IOException {
    writer.write(2, HERE);
    writer.write(1, THERE);
    assertThat(reader.read()).contains(HERE);
    nanos.addAndGet(SharedPosition.MAX_AGE_NANOS + 1);
    writer.write(1, THERE);
    assertThat(reader.read()).contains(THERE);
    writer.write(2, HERE);
    assertThat(reader.read()).contains(HERE);
  }

  @Test
  void aPositionOfBeforeTheComputersLastStartIsUnknown() throws IOException {
    writer.write(1, HERE);
    ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.nativeOrder());
    bytes.putLong(BOOT, bytes.getLong(BOOT) + 1);
    Files.write(file, bytes.array());
    assertThat(reader.read()).isEmpty();
  }

  @Test
  void aWriterThatWasKilledLeavesNothingUntilTheNext() throws IOException {
    writer.write(1, HERE);
    ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.nativeOrder());
    bytes.putLong(0, bytes.getLong(0) + 1); // it was writing
    Files.write(file, bytes.array());
    assertThat(reader.read()).isEmpty();
    writer.write(1, THERE);
    assertThat(reader.read()).contains(THERE);
  }

  private static PoseEstimate pose(double sigma, @Nullable Duration fixAge) {
    return new PoseEstimate(
        Instant.EPOCH, "atrv1/map", HERE, 0, 0, 0, 0, 0, sigma, 0, fixAge, null);
  }

  @Test
  void anEstimateCountsOnlyIfItIsCertainEnough() {
    Duration second = Duration.ofSeconds(1);
    assertThat(PositionSources.position(pose(PositionSources.MAX_SIGMA, second))).isNotNull();
    assertThat(PositionSources.position(pose(PositionSources.MAX_SIGMA + 0.1, second))).isNull();
    assertThat(PositionSources.position(pose(1, null))).as("it never had a fix").isNull();
  }
}
