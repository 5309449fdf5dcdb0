package org.dfra.core.effector;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.Arrays;
import java.util.zip.CRC32;
import org.dfra.core.time.MonotonicTimestamp;
import org.dfra.flow.effector.EmergencyStopState;
import org.jspecify.annotations.Nullable;

/**
 * Encodes an emergency stop as bytes: magic number, whether it is latched, since when (milliseconds
 * since 1970, UTC), the requester, and the same moment by the monotonic clock (nanoseconds, and the
 * boot ID); then a checksum of all that, so that corrupt data is never read as a release.
 */
final class EmergencyStopCodec {

  /** "DFE" and the format's version. */
  private static final int MAGIC = 0x44464502;

  /** The format without monotonic time, of versions before 0.2. */
  private static final int OLD_MAGIC = 0x44464501;

  /**
   * A decoded emergency stop.
   *
   * @param stop the state, of unknown age
   * @param moment when that was, by the monotonic clock
   */
  record StoredStop(EmergencyStopState stop, MonotonicTimestamp moment) {}

  private EmergencyStopCodec() {}

  static byte[] encode(boolean latched, Instant since, String by, MonotonicTimestamp moment) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeInt(MAGIC);
      out.writeBoolean(latched);
      out.writeLong(since.toEpochMilli());
      out.writeUTF(by);
      out.writeLong(moment.nanos());
      out.writeUTF(moment.bootId());
      out.writeLong(sum(bytes.toByteArray()));
    } catch (IOException e) {
      throw new UncheckedIOException(e); // writing to memory does not fail
    }
    return bytes.toByteArray();
  }

  /** The stop; null if the bytes are not a valid encoding. */
  static @Nullable StoredStop decode(byte[] content) {
    int body = content.length - Long.BYTES;
    if (body < 0 || ByteBuffer.wrap(content, body, Long.BYTES).getLong() != sum(content, body)) {
      return null;
    }
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(content, 0, body))) {
      int magic = in.readInt();
      if (magic != MAGIC && magic != OLD_MAGIC) {
        return null;
      }
      boolean latched = in.readBoolean();
      Instant since = Instant.ofEpochMilli(in.readLong());
      String by = in.readUTF();
      long nanos = magic == MAGIC ? in.readLong() : 0;
      String boot = magic == MAGIC ? in.readUTF() : "";
      return in.available() == 0
          ? new StoredStop(
              new EmergencyStopState(latched, by, since, true, null),
              new MonotonicTimestamp(boot, nanos))
          : null;
    } catch (IOException | DateTimeException e) {
      return null;
    }
  }

  private static long sum(byte[] content) {
    return sum(content, content.length);
  }

  private static long sum(byte[] content, int length) {
    CRC32 sum = new CRC32();
    sum.update(Arrays.copyOf(content, length));
    return sum.getValue();
  }
}
