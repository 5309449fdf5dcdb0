package org.dfra.river.security.robot;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileChannel.MapMode;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.dfra.core.host.PrivateFiles;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * A robot's position, in a file that all its processes have mapped: a process with a receiver or an
 * estimator writes it, and each guard reads it from memory, without a call to the system. The file
 * is small and always the same, so writing it wears out no disk.
 *
 * <p>Ages are by the monotonic clock, which on Linux is the same for all processes of a computer.
 * It begins again when the computer starts, so the file also has the computer's boot ID. Where
 * there is none, no position is known.
 */
final class SharedPosition implements AutoCloseable {

  /** Beyond this age, a position is unknown. */
  static final long MAX_AGE_NANOS = TimeUnit.SECONDS.toNanos(2);

  private static final Path BOOT_ID = Path.of("/proc/sys/kernel/random/boot_id");
  private static final VarHandle LONG =
      MethodHandles.byteBufferViewVarHandle(long[].class, ByteOrder.nativeOrder());

  /** Even while nobody writes. */
  private static final int SEQUENCE = 0;

  private static final int WRITTEN = 8; // by the monotonic clock
  private static final int BOOT = 16;
  private static final int RANK = 24;
  private static final int LATITUDE = 32;
  private static final int LONGITUDE = 40;
  private static final int HEIGHT = 48;
  private static final int BYTES = 64;

  /** Writing takes less than a microsecond. */
  private static final int ATTEMPTS = 100;

  private final FileChannel channel;
  private final MappedByteBuffer shared;
  private final long boot;
  private final LongSupplier nanos;

  @GuardedBy("this")
  private boolean isClosed;

  /** What the file has. */
  private record Entry(long written, long boot, long rank, GeoPosition position) {}

  private SharedPosition(
      FileChannel channel, MappedByteBuffer shared, long boot, LongSupplier nanos) {
    this.channel = channel;
    this.shared = shared;
    this.boot = boot;
    this.nanos = nanos;
  }

  /**
   * Maps the file, which is made if it is missing.
   *
   * @param nanos the monotonic clock of the computer, in nanoseconds
   * @throws IOException if it cannot be mapped, or this system has no boot ID
   */
  static SharedPosition open(Path file, LongSupplier nanos) throws IOException {
    UUID boot = UUID.fromString(Files.readString(BOOT_ID).strip());
    PrivateFiles.makeFile(file);
    FileChannel channel = FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE);
    boolean isMapped = false;
    try {
      MappedByteBuffer shared = channel.map(MapMode.READ_WRITE, 0, BYTES);
      shared.order(ByteOrder.nativeOrder());
      isMapped = true;
      return new SharedPosition(
          channel, shared, boot.getMostSignificantBits() ^ boot.getLeastSignificantBits(), nanos);
    } finally {
      if (!isMapped) {
        channel.close();
      }
    }
  }

  /** The position; empty if it is unknown or too old. Thread-safe; returns at once. */
  Optional<GeoPosition> read() {
    @Nullable Entry entry = fresh();
    return entry == null ? Optional.empty() : Optional.of(entry.position());
  }

  private @Nullable Entry fresh() {
    for (int i = 0; i < ATTEMPTS; i++) {
      long before = (long) LONG.getAcquire(shared, SEQUENCE);
      long written = shared.getLong(WRITTEN);
      long bootThen = shared.getLong(BOOT);
      long rank = shared.getLong(RANK);
      double latitude = shared.getDouble(LATITUDE);
      double longitude = shared.getDouble(LONGITUDE);
      double height = shared.getDouble(HEIGHT);
      VarHandle.acquireFence();
      if ((before & 1) == 0 && (long) LONG.getOpaque(shared, SEQUENCE) == before) {
        long age = nanos.getAsLong() - written;
        boolean isFresh = before != 0 && bootThen == boot && age >= 0 && age <= MAX_AGE_NANOS;
        return isFresh
            ? new Entry(written, bootThen, rank, new GeoPosition(latitude, longitude, height))
            : null;
      }
      Thread.onSpinWait();
    }
    return null; // a process was killed while it wrote
  }

  /**
   * Writes a position that was just measured, unless a better source has written one that is still
   * fresh, or another process is writing. Thread-safe.
   *
   * @param rank a higher one is better
   */
  synchronized void write(int rank, GeoPosition position) throws IOException {
    if (isClosed) {
      return;
    }
    try (@Nullable FileLock lock = channel.tryLock()) {
      @Nullable Entry other = lock == null ? null : fresh();
      if (lock == null || (other != null && other.rank() > rank)) {
        return;
      }
      long writing = (long) LONG.getOpaque(shared, SEQUENCE) | 1; // it is odd after a crash, too
      LONG.setOpaque(shared, SEQUENCE, writing);
      VarHandle.releaseFence();
      shared.putLong(WRITTEN, nanos.getAsLong());
      shared.putLong(BOOT, boot);
      shared.putLong(RANK, rank);
      shared.putDouble(LATITUDE, position.latitude());
      shared.putDouble(LONGITUDE, position.longitude());
      shared.putDouble(HEIGHT, position.height());
      LONG.setRelease(shared, SEQUENCE, writing + 1);
    }
  }

  /** Ends writing. The mapping lasts as long as somebody reads. */
  @Override
  public synchronized void close() throws IOException {
    isClosed = true;
    channel.close();
  }
}
