package org.dfra.river.transport;

import java.io.EOFException;
import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.util.Collection;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLEngineResult;
import javax.net.ssl.SSLEngineResult.HandshakeStatus;
import javax.net.ssl.SSLException;
import net.jini.io.context.ClientHost;
import net.jini.io.context.ClientSubject;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.jspecify.annotations.Nullable;

/**
 * A link that encrypts another one by TLS. Its handshake comes first: with {@link #handshake} on
 * the client's thread, with {@link #advance} in steps that never wait on the server.
 *
 * <p>It has buffers only while something is in them, so that idle connections cost little. The end
 * of the other link counts as the end of this one: messages have lengths, so none can be cut
 * unnoticed.
 */
final class TlsLink extends ForwardingLink {

  private static final System.Logger LOG = System.getLogger(TlsLink.class.getName());

  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  /**
   * The most data that a peer may send before its handshake is over, in bytes. A handshake has less
   * than 8 KiB; the first request may follow it in the same packets.
   */
  private static final int MAX_HANDSHAKE = 32 * 1024;

  /** The size of a record's header, in bytes; the last two are the length of what follows. */
  private static final int HEADER_BYTES = 5;

  private static final int LENGTH_AT = 3;

  /**
   * So many records without data a peer may send after the handshake, such as tickets and requests
   * for new keys, and one more for each {@value #DATA_FOR_SILENT} records with data. JSSE itself
   * sends two tickets at most, and new keys after 128 GiB.
   */
  private static final int MAX_SILENT = 32;

  private static final int DATA_FOR_SILENT = 1024;

  private final TlsEngine engine;
  private final ChannelIdentity identity;
  private final boolean isServer;
  private boolean blocking;
  private int handshakeBytes;
  private long silentRecords;
  private long dataRecords;

  private @Nullable ByteBuffer sealed; // received and not decrypted, ready to be appended to
  private @Nullable ByteBuffer open; // decrypted and not read, ready to be read from
  private @Nullable ByteBuffer leaving; // encrypted and not sent, ready to be read from

  private volatile @Nullable ChannelPeer partner;

  /** Whether the handshake is over, also if its peer is not believed. */
  private volatile boolean isEncrypted;

  /**
   * The client's end.
   *
   * @param link to the server, which has said that it encrypts
   */
  static TlsLink client(Link link, ChannelIdentity identity, String host, int port) {
    return new TlsLink(link, identity, identity.clientEngine(host, port), false);
  }

  /**
   * The server's end.
   *
   * @param link to the client, which is not blocking
   */
  static TlsLink server(Link link, ChannelIdentity identity) {
    return new TlsLink(link, identity, identity.serverEngine(), true);
  }

  private TlsLink(Link link, ChannelIdentity identity, SSLEngine engine, boolean isServer) {
    super(link);
    this.identity = identity;
    this.engine = new TlsEngine(engine);
    this.isServer = isServer;
    this.blocking = !isServer;
  }

  /** The whole handshake, on a blocking link. */
  void handshake() throws IOException {
    while (!advance()) {
      // each step of a blocking link waits for what it needs
    }
  }

  /**
   * Goes on with the handshake.
   *
   * @return whether it is over; false if it needs bytes that have not arrived
   * @throws IOException if it failed, or the peer is not believed
   */
  boolean advance() throws IOException {
    try {
      return advanced();
    } catch (SSLException e) {
      sayWhy();
      throw e;
    } finally {
      freeEmpty();
    }
  }

  /** Sends the alert that says why this end gives up, if there is one. */
  private void sayWhy() {
    try {
      if (engine.status() == HandshakeStatus.NEED_WRAP) {
        boolean unused = isSent(NOTHING);
      }
    } catch (IOException e) {
      LOG.log(Level.TRACE, "A peer does not learn why a handshake failed.", e);
    }
  }

  private boolean advanced() throws IOException {
    if (engine.status() == HandshakeStatus.NOT_HANDSHAKING && partner == null) {
      engine.begin();
    }
    while (true) {
      HandshakeStatus next = engine.status();
      switch (next) {
        case NEED_TASK -> engine.runTasks();
        case NEED_WRAP -> {
          if (!isSent(NOTHING)) {
            throw new IOException("the peer takes no bytes of the handshake");
          }
        }
        case NEED_UNWRAP, NEED_UNWRAP_AGAIN -> {
          if (!unwrapHandshake()) {
            return false;
          }
        }
        case FINISHED, NOT_HANDSHAKING -> {
          isEncrypted = true;
          partner = identity.peer(engine.session(), address(), !isServer);
          return true;
        }
      }
    }
  }

  /**
   * Whether the handshake is over, but the peer is not believed: a revoked one resumes its session.
   */
  boolean isRefused() {
    return isEncrypted && partner == null;
  }

  /** The next connection to this peer does not resume the session of this one. */
  void forgetSession() {
    engine.session().invalidate();
  }

  private String address() {
    return link.peer().address().getHostAddress();
  }

  /** Returns false if bytes are missing and the link does not wait. */
  private boolean unwrapHandshake() throws IOException {
    ByteBuffer from = sealed();
    from.flip();
    SSLEngineResult result;
    try {
      result = engine.unwrap(from, NOTHING);
    } finally {
      from.compact();
    }
    switch (result.getStatus()) {
      case OK -> {
        return true;
      }
      case BUFFER_UNDERFLOW -> {
        int count = receive();
        handshakeBytes += count;
        if (handshakeBytes > MAX_HANDSHAKE) {
          throw new SSLException("the handshake is longer than " + MAX_HANDSHAKE + " bytes");
        }
        return count > 0;
      }
      default -> throw new SSLException("the handshake ended: " + result.getStatus());
    }
  }

  /** Receives more of what is encrypted. Returns the number of bytes, 0 if there are none now. */
  private int receive() throws IOException {
    int count = receiveMore();
    if (count < 0) {
      throw new EOFException("the peer has closed the connection");
    }
    return count;
  }

  /** As reading the other link does. */
  private int receiveMore() throws IOException {
    ByteBuffer into = sealed();
    if (!into.hasRemaining()) {
      throw new SSLException("a record is longer than TLS allows");
    }
    return link.read(into);
  }

  /** Whether a whole record has been received, or the beginning of one that is too long. */
  private boolean hasRecord() {
    ByteBuffer received = sealed;
    if (received == null || received.position() < HEADER_BYTES) {
      return false;
    }
    int length = HEADER_BYTES + (received.getShort(LENGTH_AT) & 0xffff);
    return received.position() >= length || length > received.capacity();
  }

  private ByteBuffer sealed() {
    ByteBuffer buffer = sealed;
    if (buffer == null) {
      buffer = BufferPool.RECORDS.take();
      sealed = buffer;
    }
    return buffer;
  }

  /** Frees the buffers that are empty. */
  private void freeEmpty() {
    ByteBuffer cipher = sealed;
    if (cipher != null && cipher.position() == 0) {
      sealed = null;
      BufferPool.RECORDS.giveBack(cipher);
    }
  }

  /** Reads the data of one record at most, so that a peer that sends many gets no more turns. */
  @Override
  public int read(ByteBuffer into) throws IOException {
    int count = readRecord(into);
    if (!blocking || count < 0) {
      freeEmpty();
    }
    return count;
  }

  private int readRecord(ByteBuffer into) throws IOException {
    while (true) {
      int count = takeDecrypted(into);
      if (count > 0 || !into.hasRemaining()) {
        return count;
      }
      if (hasRecord()) {
        count = decrypt(into);
        if (count != 0) {
          return count;
        }
      } else {
        int received = receiveMore();
        if (received <= 0) {
          return received;
        }
      }
    }
  }

  private int takeDecrypted(ByteBuffer into) {
    ByteBuffer ready = open;
    if (ready == null) {
      return 0;
    }
    int count = Math.min(ready.remaining(), into.remaining());
    ByteBuffer part = ready.slice().limit(count);
    into.put(part);
    ready.position(ready.position() + count);
    if (!ready.hasRemaining()) {
      open = null;
      BufferPool.RECORDS.giveBack(ready);
    }
    return count;
  }

  /**
   * Decrypts the next record, into the given buffer if it fits, otherwise aside.
   *
   * @return number of bytes in the given buffer, 0 if it had no data or they are aside; -1 at the
   *     end
   */
  private int decrypt(ByteBuffer into) throws IOException {
    ByteBuffer from = sealed();
    from.flip();
    int before = into.position();
    SSLEngineResult result;
    try {
      result = engine.unwrap(from, into);
      if (result.getStatus() == SSLEngineResult.Status.BUFFER_OVERFLOW) {
        result = decryptAside(from);
      }
    } finally {
      from.compact();
    }
    answerIfNeeded();
    if (result.getStatus() == SSLEngineResult.Status.CLOSED) {
      return -1;
    } else if (result.getStatus() != SSLEngineResult.Status.OK) {
      throw new SSLException("a record is longer than TLS allows");
    }
    int count = into.position() - before;
    countRecord(count > 0 || open != null);
    return count;
  }

  /** Each request for new keys costs this end as much as many calls. */
  private void countRecord(boolean hasData) throws SSLException {
    if (hasData) {
      dataRecords++;
      return;
    }
    silentRecords++;
    if (silentRecords > MAX_SILENT + dataRecords / DATA_FOR_SILENT) {
      throw new SSLException("the peer sends records without data");
    }
  }

  private SSLEngineResult decryptAside(ByteBuffer from) throws IOException {
    ByteBuffer aside = BufferPool.RECORDS.take();
    SSLEngineResult result = engine.unwrap(from, aside);
    if (result.getStatus() == SSLEngineResult.Status.BUFFER_OVERFLOW) {
      throw new SSLException("a record is longer than TLS allows");
    }
    aside.flip();
    if (aside.hasRemaining()) {
      open = aside;
    } else {
      BufferPool.RECORDS.giveBack(aside);
    }
    return result;
  }

  /** A peer may ask for new keys at any time. */
  private void answerIfNeeded() throws IOException {
    while (true) {
      switch (engine.status()) {
        case NEED_TASK -> engine.runTasks();
        case NEED_WRAP -> {
          if (!isSent(NOTHING)) {
            throw new IOException("the peer takes no answer to its request for new keys");
          }
        }
        default -> {
          return;
        }
      }
    }
  }

  @Override
  public int write(ByteBuffer from) throws IOException {
    int before = from.position();
    do {
      if (!isSent(from)) {
        return 0; // what is left of a record may leave later; its sender gives up now
      }
    } while (from.hasRemaining());
    return from.position() - before;
  }

  /** Encrypts one record and sends it. Returns false if the link does not take all of it now. */
  private boolean isSent(ByteBuffer from) throws IOException {
    ByteBuffer to = leaving;
    if (to == null) {
      to = BufferPool.RECORDS.take();
      SSLEngineResult result = engine.wrap(from, to);
      boolean isAlert = result.getStatus() == SSLEngineResult.Status.CLOSED && from == NOTHING;
      if ((result.getStatus() != SSLEngineResult.Status.OK && !isAlert)
          || result.bytesProduced() == 0) {
        throw new SSLException("nothing more can be encrypted: " + result.getStatus());
      }
      to.flip();
      leaving = to;
    }
    while (to.hasRemaining()) {
      if (link.write(to) == 0 && !blocking) {
        return false;
      }
    }
    leaving = null;
    BufferPool.RECORDS.giveBack(to);
    return true;
  }

  /** Half a record does not count: its rest will be announced. */
  @Override
  public boolean hasReceived() {
    return open != null || hasRecord();
  }

  @Override
  public int held() {
    return (sealed == null ? 0 : sealed.capacity()) + (open == null ? 0 : open.capacity());
  }

  @Override
  public void setBlocking(boolean blocking) throws IOException {
    this.blocking = blocking;
    super.setBlocking(blocking);
    if (!blocking) {
      freeEmpty();
    }
  }

  @Override
  public @Nullable ChannelPeer partner() {
    return partner;
  }

  @Override
  public void addClientTo(Collection<Object> context) {
    InetAddress address = link.peer().address();
    context.add((ClientHost) () -> address);
    ChannelPeer client = partner;
    if (client != null) {
      context.add((ClientSubject) client::subject);
      context.add(client.caller());
      context.add(client);
    }
  }
}
