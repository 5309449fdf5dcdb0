package org.dfra.drivers.pantilt.ptu;

import java.nio.charset.StandardCharsets;
import org.dfra.drivers.pantilt.ptu.PtuReply.Done;
import org.dfra.drivers.pantilt.ptu.PtuReply.LimitHit;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;

/** Decodes the replies that a {@link PtuFramer} has found. Never throws, whatever the bytes. */
public final class PtuDecoder {

  private PtuDecoder() {}

  /** Decodes one reply. */
  public static PtuReply decode(byte[] bytes, int offset, int length) {
    String line = new String(bytes, offset, length, StandardCharsets.US_ASCII).strip();
    if (line.equals("!P") || line.equals("!T")) {
      return new LimitHit(line.endsWith("P") ? PtuAxis.PAN : PtuAxis.TILT);
    }
    String text = line.isEmpty() ? "" : line.substring(1).strip();
    if (line.startsWith("!")) {
      return new Refused(text);
    }
    return text.isEmpty() ? new Done() : new Value(text);
  }
}
