package org.dfra.river.phoenix;

import com.sun.jini.reliableLog.LogHandler;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.zip.CRC32C;
import org.dfra.core.config.RecordedNames;
import org.dfra.river.filter.SerialFilters;

/**
 * The format of the journal's snapshot and records: serialized objects behind their length and a
 * CRC-32C. So a torn record (written incompletely) is detected.
 */
final class JournalHandler extends LogHandler {

  /** Bytes before the object: its length and its CRC. */
  private static final int HEAD = 8;

  private Registrations registrations;
  private int records;

  /** Creates a handler that reads a journal. */
  JournalHandler() {
    this(new Registrations());
  }

  /** Creates a handler that writes these registrations. */
  JournalHandler(Registrations registrations) {
    this.registrations = registrations;
  }

  /** The registrations that were read. */
  Registrations registrations() {
    return registrations;
  }

  @Override
  public void snapshot(OutputStream out) throws IOException {
    write(out, registrations);
  }

  @Override
  public void recover(InputStream in) throws IOException, ClassNotFoundException {
    registrations = (Registrations) deserialize(checked(in.readAllBytes(), "the snapshot"));
  }

  @Override
  public void writeUpdate(OutputStream out, Object value) throws IOException {
    write(out, value);
  }

  @Override
  public void readUpdate(InputStream in) throws IOException, ClassNotFoundException {
    records++;
    // River's stream refuses reads beyond the record, and reports the record's length.
    byte[] whole = in.readNBytes(in.available());
    if (isWhole(whole, 0, whole.length)) { // else it is the torn last one; JournalScan checked that
      registrations.apply((JournalRecord) deserialize(checked(whole, "record " + records)));
    }
  }

  @Override
  public void applyUpdate(Object update) {
    registrations.apply((JournalRecord) update);
  }

  private static void write(OutputStream out, Object value) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream objects = new ObjectOutputStream(bytes)) {
      objects.writeObject(value);
    }
    ByteArrayOutputStream whole = new ByteArrayOutputStream(bytes.size() + HEAD);
    DataOutputStream data = new DataOutputStream(whole);
    data.writeInt(bytes.size());
    data.writeInt(crc(bytes.toByteArray(), 0, bytes.size()));
    bytes.writeTo(data);
    out.write(whole.toByteArray());
    out.flush();
  }

  private static byte[] checked(byte[] whole, String what) throws IOException {
    if (isWhole(whole, 0, whole.length)) {
      return java.util.Arrays.copyOfRange(whole, HEAD, whole.length);
    }
    throw new IOException(what + " is damaged");
  }

  /** Whether these bytes are a complete record of this class. */
  static boolean isWhole(byte[] bytes, int from, int length) {
    if (length < HEAD || from + length > bytes.length) {
      return false;
    }
    ByteBuffer head = ByteBuffer.wrap(bytes, from, HEAD);
    return head.getInt() == length - HEAD
        && head.getInt() == crc(bytes, from + HEAD, length - HEAD);
  }

  private static int crc(byte[] bytes, int from, int length) {
    CRC32C crc = new CRC32C();
    crc.update(bytes, from, length);
    return (int) crc.getValue();
  }

  private static Object deserialize(byte[] bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in =
        SerialFilters.guardStored(
            new ObjectInputStream(new ByteArrayInputStream(RecordedNames.translate(bytes))))) {
      return in.readObject();
    }
  }
}
