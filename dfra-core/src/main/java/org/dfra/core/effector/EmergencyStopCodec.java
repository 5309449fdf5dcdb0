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
 * An emergency stop as bytes: magic number, whether it is latched, since when (milliseconds since
 * 1970, UTC), by whom, and the same moment by monotonic time (nanoseconds, and the boot); then a
 * check sum of all that, so that damage is never taken for a release.
 */
final class EmergencyStopCodec {

  /** "DFE" and the form's version. */
  private static final int MAGIC = 0x44464502;

  /** The same without monotonic time, as versions before 0.2 wrote it. */
  private static final int OLD_MAGIC = 0x44464501;

  /**
   * What was read.
   *
   * @param stop of unknown age
   * @param moment when that was, by monotonic time
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
      throw new UncheckedIOException(e); // there is always memory to write to
    }
    return bytes.toByteArray();
  }

  /** The stop; null where these are not the bytes of one. */
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
