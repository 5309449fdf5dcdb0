package org.dfra.core.history;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.lifecycle.Incident;
import org.dfra.module.ModuleHistory;

/** Encodes a history as bytes. */
final class HistoryCodec {

  /** "DFH" and the format's version. */
  private static final int MAGIC = 0x44464801;

  /**
   * Maximum stored characters of an incident's description; at three bytes each they fit into
   * writeUTF.
   */
  private static final int LONGEST_TEXT = 2000;

  private HistoryCodec() {}

  static byte[] encode(ModuleHistory history) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeInt(MAGIC);
      write(out, history.since());
      out.writeLong(history.activations());
      out.writeLong(history.failures());
      out.writeLong(history.exceptions());
      out.writeLong(history.servingTime().toMillis());
      out.writeInt(history.recent().size());
      for (Incident incident : history.recent()) {
        write(out, incident.time());
        out.writeUTF(incident.kind().name());
        String what = incident.description();
        out.writeUTF(what.substring(0, Math.min(LONGEST_TEXT, what.length())));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e); // writing to memory does not fail
    }
    return bytes.toByteArray();
  }

  /**
   * @throws IOException if these are not the bytes of a history
   */
  static ModuleHistory decode(byte[] content) throws IOException {
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(content))) {
      if (in.readInt() != MAGIC) {
        throw new IOException("it was written by something else");
      }
      Instant since = readInstant(in);
      long activations = in.readLong();
      long failures = in.readLong();
      long exceptions = in.readLong();
      Duration served = Duration.ofMillis(in.readLong());
      int count = in.readInt();
      if (count < 0 || count > IncidentLog.MAX_INCIDENTS) {
        throw new IOException(
            "it contains " + count + " incidents, which is not 0 to " + IncidentLog.MAX_INCIDENTS);
      }
      List<Incident> recent = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        Instant when = readInstant(in);
        recent.add(new Incident(when, Incident.Kind.valueOf(in.readUTF()), in.readUTF()));
      }
      return new ModuleHistory(since, activations, failures, exceptions, served, recent);
    } catch (IllegalArgumentException | DateTimeException e) {
      throw new IOException("it is damaged", e);
    }
  }

  private static void write(DataOutputStream out, Instant instant) throws IOException {
    out.writeLong(instant.getEpochSecond());
    out.writeInt(instant.getNano());
  }

  private static Instant readInstant(DataInputStream in) throws IOException {
    return Instant.ofEpochSecond(in.readLong(), in.readInt());
  }
}
