package org.dfra.river.access;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.StreamCorruptedException;

/**
 * A credential in the bytes of a call, in front of the method's number: {@link #MARK}, the form, a
 * length and as many bytes. A call without one has nothing there. A server that does not know it
 * takes the mark for the number of a method that it does not have, and refuses the call.
 */
public final class CallCredential {

  /** In place of the number of a method. No number is chosen: it is the hash of a signature. */
  public static final long MARK = 0x4446_5241_4352_4544L; // "DFRACRED"

  /** The most bytes that a call may carry. */
  public static final int MAX_BYTES = 4096;

  private static final int FORM = 1;

  private CallCredential() {}

  /** Writes it; the method's number follows. */
  public static void write(byte[] credential, ObjectOutputStream out) throws IOException {
    if (credential.length > MAX_BYTES) {
      throw new IOException(
          "a credential of " + credential.length + " bytes > " + MAX_BYTES + " allowed");
    }
    out.writeLong(MARK);
    out.writeByte(FORM);
    out.writeShort(credential.length);
    out.write(credential);
  }

  /**
   * Reads what follows {@link #MARK}. Its length is checked before memory is used for it.
   *
   * @throws StreamCorruptedException if it has another form, or is too long
   */
  static byte[] read(ObjectInputStream in) throws IOException {
    int form = in.readUnsignedByte();
    if (form != FORM) {
      throw new StreamCorruptedException(
          "the call carries a credential of form " + form + ", and this process knows " + FORM);
    }
    int length = in.readUnsignedShort();
    if (length > MAX_BYTES) {
      throw new StreamCorruptedException(
          "the call carries a credential of " + length + " bytes > " + MAX_BYTES + " allowed");
    }
    byte[] credential = new byte[length];
    in.readFully(credential);
    return credential;
  }
}
