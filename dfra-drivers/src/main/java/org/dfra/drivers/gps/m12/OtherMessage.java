package org.dfra.drivers.gps.m12;

import java.util.Arrays;
import java.util.HexFormat;

/** An intact frame of an ID that has no decoder (yet). Immutable: the payload is copied. */
public record OtherMessage(String id, byte[] payload) implements M12Message {

  /**
   * @param id the frame's two letters
   * @param payload the bytes after the ID and before the checksum
   */
  public OtherMessage {
    payload = payload.clone();
  }

  @Override
  public byte[] payload() {
    return payload.clone();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof OtherMessage o && id.equals(o.id) && Arrays.equals(payload, o.payload);
  }

  @Override
  public int hashCode() {
    return 31 * id.hashCode() + Arrays.hashCode(payload);
  }

  @Override
  public String toString() {
    return "OtherMessage[@@" + id + " " + HexFormat.of().formatHex(payload) + "]";
  }
}
