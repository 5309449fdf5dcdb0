package org.dfra.river.transport;

import java.io.IOException;
import java.nio.ByteBuffer;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;

/**
 * The first bytes in each direction. The client's: "DFRA", the version of the format, 1 if TLS
 * follows and 0 if not, 1 if it is for an emergency stop and 0 if not, a zero, and the ID of the
 * server that it wants (zero for any). The server's: "DFRA", the version that it speaks, a {@link
 * Answer} and two zeros.
 *
 * <p>A client sends nothing else before it has the server's greeting. So a request never waits at a
 * server that is suspended and executes it long after the client has given it up.
 */
final class Greeting {

  /** The format of everything that follows. */
  static final int VERSION = 1;

  /** The size of a client's greeting, in bytes. */
  static final int CLIENT_BYTES = 24;

  /** The size of a server's greeting, in bytes. */
  static final int SERVER_BYTES = 8;

  /** For a client that names no server. */
  static final Uuid ANY_SERVER = UuidFactory.create(0, 0);

  private static final int ENCRYPTED = 1 << 16;
  private static final int FOR_STOP = 1 << 8;

  private static final int MAGIC = 'D' << 24 | 'F' << 16 | 'R' << 8 | 'A';

  /** What a server says to a client's greeting. */
  enum Answer {
    /** Send requests. */
    WELCOME("it accepts them"),
    /** Another server than the one that is wanted. */
    OTHER_SERVER("another server is there now"),
    /** Too many connections; try later. */
    BUSY("it has too many connections"),
    /** It does not speak the client's version. */
    OTHER_VERSION("it has another version of the transport; use the same release of DFRA"),
    /** It serves encrypted calls only. */
    ENCRYPTED_ONLY(
        "it serves members of its team only; join the team on this computer (security join)"),
    /** It has no keys, so it cannot encrypt. */
    NOT_ENCRYPTED("it has joined no team, so its calls are not encrypted");

    private final String sentence;

    Answer(String sentence) {
      this.sentence = sentence;
    }

    /** The reason, as the end of a sentence about the server. */
    String sentence() {
      return sentence;
    }
  }

  private Greeting() {}

  /**
   * Writes a client's greeting.
   *
   * @param isEncrypted whether TLS follows
   * @param isForStop whether the connection is for an emergency stop
   */
  static void putClient(ByteBuffer to, Uuid server, boolean isEncrypted, boolean isForStop) {
    to.putInt(MAGIC)
        .putInt(VERSION << 24 | (isEncrypted ? ENCRYPTED : 0) | (isForStop ? FOR_STOP : 0));
    to.putLong(server.getMostSignificantBits()).putLong(server.getLeastSignificantBits());
  }

  /** Whether a client's greeting, ready to be read from, is for an emergency stop. */
  static boolean isForStop(ByteBuffer from) {
    return (from.getInt(from.position() + Integer.BYTES) & FOR_STOP) != 0;
  }

  /**
   * Reads a client's greeting.
   *
   * @param own ID of this server
   * @param isEncrypted whether this server encrypts
   * @return the answer to it
   * @throws IOException if it is none
   */
  static Answer readClient(ByteBuffer from, Uuid own, boolean isEncrypted) throws IOException {
    if (from.getInt() != MAGIC) {
      throw new IOException("the peer is no client of this protocol");
    }
    int head = from.getInt();
    int version = head >>> 24;
    boolean wantsEncryption = (head & ENCRYPTED) != 0;
    Uuid wanted = UuidFactory.create(from.getLong(), from.getLong());
    if (version != VERSION) {
      return Answer.OTHER_VERSION;
    }
    if (wantsEncryption != isEncrypted) {
      return isEncrypted ? Answer.ENCRYPTED_ONLY : Answer.NOT_ENCRYPTED;
    }
    return wanted.equals(ANY_SERVER) || wanted.equals(own) ? Answer.WELCOME : Answer.OTHER_SERVER;
  }

  /** A server's greeting. */
  static ByteBuffer server(Answer answer) {
    return ByteBuffer.allocate(SERVER_BYTES)
        .putInt(MAGIC)
        .put((byte) VERSION)
        .put((byte) answer.ordinal())
        .putShort((short) 0)
        .flip();
  }

  /**
   * Reads a server's greeting.
   *
   * @throws IOException if it is none
   */
  static Answer readServer(ByteBuffer from) throws IOException {
    if (from.getInt() != MAGIC) {
      throw new IOException("the peer is no server of DFRA's transport");
    }
    int version = from.get();
    int answer = from.get();
    from.getShort();
    if (answer < 0 || answer >= Answer.values().length) {
      throw new IOException("the server's greeting has an unknown answer " + answer);
    }
    if (version != VERSION) {
      throw new IOException(
          "the server speaks version "
              + version
              + " of DFRA's transport, and this program version "
              + VERSION
              + "; use the same release of DFRA on both computers");
    }
    return Answer.values()[answer];
  }
}
