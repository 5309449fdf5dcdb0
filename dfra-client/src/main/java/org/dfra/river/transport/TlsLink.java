package org.dfra.river.transport;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectableChannel;
import java.util.Collection;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLEngineResult;
import javax.net.ssl.SSLEngineResult.HandshakeStatus;
import javax.net.ssl.SSLException;
import net.jini.io.context.ClientHost;
import net.jini.io.context.ClientSubject;
import org.jspecify.annotations.Nullable;

/**
 * A link that encrypts another one by TLS. Its handshake comes first: with {@link #handshake} on
 * the client's thread, with {@link #advance} in steps that never wait on the server.
 *
 * <p>It has buffers only while something is in them, so that idle connections cost little. The end
 * of the other link counts as the end of this one: messages have lengths, so none can be cut
 * unnoticed.
 */
final class TlsLink implements Link {

  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  /** The most data that a peer may send before its handshake is over, in bytes. */
  private static final int MAX_HANDSHAKE = 64 * 1024;

  private final Link link;
  private final SSLEngine engine;
  private final ChannelIdentity identity;
  private final boolean isServer;
  private boolean blocking;
  private int handshakeBytes;

  private @Nullable ByteBuffer sealed; // received and not decrypted, ready to be appended to
  private @Nullable ByteBuffer open; // decrypted and not read, ready to be read from
  private @Nullable ByteBuffer leaving; // encrypted and not sent, ready to be read from

  private volatile @Nullable ChannelPeer partner;

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
    this.link = link;
    this.identity = identity;
    this.engine = engine;
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
    if (engine.getHandshakeStatus() == HandshakeStatus.NOT_HANDSHAKING && partner == null) {
      engine.beginHandshake();
    }
    while (true) {
      HandshakeStatus next = engine.getHandshakeStatus();
      switch (next) {
        case NEED_TASK -> runTasks();
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
          partner = identity.peer(engine.getSession(), address(), !isServer);
          return true;
        }
      }
    }
  }

  private String address() {
    return link.peer().address().getHostAddress();
  }

  private void runTasks() {
    for (Runnable task = engine.getDelegatedTask();
        task != null;
        task = engine.getDelegatedTask()) {
      task.run();
    }
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
    ByteBuffer into = sealed();
    int count = link.read(into);
    if (count < 0) {
      throw new EOFException("the peer has closed the connection");
    }
    return count;
  }

  private ByteBuffer sealed() {
    ByteBuffer buffer = sealed;
    if (buffer == null) {
      buffer = TlsBuffers.take();
      sealed = buffer;
    }
    return buffer;
  }

  /** Frees the buffers that are empty. */
  private void freeEmpty() {
    ByteBuffer cipher = sealed;
    if (cipher != null && cipher.position() == 0) {
      sealed = null;
      TlsBuffers.giveBack(cipher);
    }
  }

  @Override
  public int read(ByteBuffer into) throws IOException {
    while (true) {
      int count = takeDecrypted(into);
      if (count > 0) {
        return count;
      }
      if (!into.hasRemaining()) {
        return 0;
      }
      count = decrypt(into);
      if (count != 0) {
        return count;
      }
      if (open == null) { // more bytes are needed
        int received = link.read(sealed());
        if (received <= 0) {
          freeEmpty();
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
      TlsBuffers.giveBack(ready);
    }
    return count;
  }

  /**
   * Decrypts the next record, into the given buffer if it fits, otherwise aside.
   *
   * @return number of bytes in the given buffer; -1 at the end
   */
  private int decrypt(ByteBuffer into) throws IOException {
    while (true) {
      ByteBuffer from = sealed();
      if (from.position() == 0) {
        return 0;
      }
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
      }
      int count = into.position() - before;
      if (count > 0 || open != null || result.getStatus() != SSLEngineResult.Status.OK) {
        return count;
      }
    }
  }

  private SSLEngineResult decryptAside(ByteBuffer from) throws IOException {
    ByteBuffer aside = TlsBuffers.take();
    SSLEngineResult result = engine.unwrap(from, aside);
    if (result.getStatus() == SSLEngineResult.Status.BUFFER_OVERFLOW) {
      throw new SSLException("a record is longer than TLS allows");
    }
    aside.flip();
    if (aside.hasRemaining()) {
      open = aside;
    } else {
      TlsBuffers.giveBack(aside);
    }
    return result;
  }

  /** A peer may ask for new keys at any time. */
  private void answerIfNeeded() throws IOException {
    while (true) {
      switch (engine.getHandshakeStatus()) {
        case NEED_TASK -> runTasks();
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
      to = TlsBuffers.take();
      SSLEngineResult result = engine.wrap(from, to);
      if (result.getStatus() != SSLEngineResult.Status.OK) {
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
    TlsBuffers.giveBack(to);
    return true;
  }

  /** Whether bytes of the peer are here that the channel does not announce any more. */
  @Override
  public boolean hasReceived() {
    return open != null || (sealed != null && sealed.position() > 0);
  }

  @Override
  public void setBlocking(boolean blocking) throws IOException {
    this.blocking = blocking;
    link.setBlocking(blocking);
    if (!blocking) {
      freeEmpty();
    }
  }

  @Override
  public void endOutput() throws IOException {
    link.endOutput();
  }

  @Override
  public void endInput() throws IOException {
    link.endInput();
  }

  @Override
  public SelectableChannel channel() {
    return link.channel();
  }

  @Override
  public Peer peer() {
    return link.peer();
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

  @Override
  public void close() throws IOException {
    link.close();
  }
}
