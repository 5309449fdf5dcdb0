package org.dfra.river.phoenix.access;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Replaces the caller's address in the acknowledgement at the beginning of a JRMP server's output.
 *
 * <p>The acknowledgement of the stream protocol is a byte 4E (hexadecimal), then the caller's
 * address as the server sees it, in modified UTF-8 with its length, then its port. A client that
 * does not know its own address exports its objects at that address. All other bytes pass
 * unchanged. Source: Java RMI specification, 10.2, "RMI Transport Protocol".
 */
final class AddressRewritingStream extends FilterOutputStream {

  private static final int ACKNOWLEDGED = 0x4E;

  private final byte[] expected;
  private final byte[] replacement;
  private int matched; // of the expected bytes, which are buffered
  private boolean passes;

  /**
   * @param out the underlying stream
   * @param seen the address that the server writes
   * @param sent the address that replaces it
   */
  AddressRewritingStream(OutputStream out, String seen, String sent) throws IOException {
    super(out);
    this.expected = acknowledgement(seen);
    this.replacement = acknowledgement(sent);
  }

  private static byte[] acknowledgement(String address) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeByte(ACKNOWLEDGED);
    out.writeUTF(address);
    return bytes.toByteArray();
  }

  @Override
  public void write(int value) throws IOException {
    write(new byte[] {(byte) value}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    int at = offset;
    int end = offset + length;
    while (!passes && at < end) {
      if (bytes[at] != expected[matched]) {
        passes = true;
        out.write(expected, 0, matched);
      } else {
        at++;
        matched++;
        if (matched == expected.length) {
          passes = true;
          out.write(replacement);
        }
      }
    }
    if (at < end) {
      out.write(bytes, at, end - at);
    }
  }
}
