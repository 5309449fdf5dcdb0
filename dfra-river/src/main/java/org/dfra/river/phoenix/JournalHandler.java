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

/**
 * How the journal's snapshot and records are written: serialized objects behind their length and a
 * CRC-32C, so that a torn record is told from a good one.
 */
final class JournalHandler extends LogHandler {

  private Registrations registrations;
  private int records;
  private int tornRecord;

  /** For reading a journal. */
  JournalHandler() {
    this(new Registrations());
  }

  /** For writing these registrations. */
  JournalHandler(Registrations registrations) {
    this.registrations = registrations;
  }

  /** What was read. */
  Registrations registrations() {
    return registrations;
  }

  /** Whether the last record was torn. */
  boolean droppedTornRecord() {
    return tornRecord > 0;
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
    if (tornRecord > 0) {
      throw new IOException("record " + tornRecord + " is damaged and others follow it");
    }
    byte[] bytes;
    try {
      // River's stream refuses to be read beyond the record, and says how long that is.
      bytes = checked(in.readNBytes(in.available()), "record " + records);
    } catch (IOException e) {
      tornRecord = records;
      return;
    }
    registrations.apply((Change) deserialize(bytes));
  }

  @Override
  public void applyUpdate(Object update) {
    registrations.apply((Change) update);
  }

  private static void write(OutputStream out, Object value) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream objects = new ObjectOutputStream(bytes)) {
      objects.writeObject(value);
    }
    ByteArrayOutputStream whole = new ByteArrayOutputStream(bytes.size() + 8);
    DataOutputStream data = new DataOutputStream(whole);
    data.writeInt(bytes.size());
    data.writeInt(crc(bytes.toByteArray(), 0));
    bytes.writeTo(data);
    out.write(whole.toByteArray());
    out.flush();
  }

  private static byte[] checked(byte[] whole, String what) throws IOException {
    if (whole.length >= 8) {
      ByteBuffer head = ByteBuffer.wrap(whole);
      if (head.getInt() == whole.length - 8 && head.getInt() == crc(whole, 8)) {
        return java.util.Arrays.copyOfRange(whole, 8, whole.length);
      }
    }
    throw new IOException(what + " is damaged");
  }

  private static int crc(byte[] bytes, int from) {
    CRC32C crc = new CRC32C();
    crc.update(bytes, from, bytes.length - from);
    return (int) crc.getValue();
  }

  private static Object deserialize(byte[] bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      return in.readObject();
    }
  }
}
