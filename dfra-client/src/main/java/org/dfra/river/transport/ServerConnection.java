package org.dfra.river.transport;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.util.Objects;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.ConnectionLimits.Resource;
import org.jspecify.annotations.Nullable;

/**
 * One connection of a client. Either the selector has it, or a worker serves it:
 *
 * <pre>
 *   GREETING [-&gt; HANDSHAKE] -&gt; IDLE -&gt; PARTIAL -&gt; | SERVING -&gt; WAITING -&gt; SERVING ... | -&gt; IDLE
 *               selector              | worker                           |
 * </pre>
 *
 * <p>{@code CLOSING} may follow each of them: the client was informed, and has a moment to close
 * it.
 */
final class ServerConnection implements Runnable {

  /** Who has the connection, and what for. */
  enum State {
    /** The selector, until the client's greeting is complete. */
    GREETING,
    /** The selector, or a thread for handshakes, until it is encrypted. */
    HANDSHAKE,
    /** The selector, until a request begins. */
    IDLE,
    /** The selector, until the first block of a request is complete. */
    PARTIAL,
    /** A worker, which receives the rest of a request. */
    RECEIVING,
    /** A worker, while the object executes the call. */
    EXECUTING,
    /** A worker, which sends the response. */
    ANSWERING,
    /** A worker, until the next request begins. */
    WAITING,
    /** The selector, until the client closes it. */
    CLOSING
  }

  private static final System.Logger LOG = System.getLogger(ServerConnection.class.getName());

  /** The longest rest of a refused request that is skipped, in bytes. */
  private static final long MAX_SKIPPED = 64 << 20;

  private static final byte[] NOTHING = {};

  private final ServerPort port;
  private volatile Link link;
  private final ConnectionSelector selector;
  private final ConnectionLimits limits;

  private volatile State state = State.GREETING; // changed under this

  /** When the state began or bytes were last transferred in it, as {@link System#nanoTime()}. */
  private volatile long since = System.nanoTime();

  /** When the current request began to arrive. */
  private volatile long requestBegan = since;

  private volatile byte[] partial = NOTHING; // the selector's
  private volatile int kept; // bytes that count as partial, the selector's
  private @Nullable ByteBuffer input; // the worker's, ready to be read from
  private long bytesTaken; // the workers'
  private boolean isReceiver; // whether the worker counts as one
  private boolean mayWait; // whether the worker counts as one that may wait
  private StopLane.@Nullable Share
      share; // of what is kept for stops, if it has the worker's thread
  private volatile long preferredUntil; // 0: it is not; System.nanoTime() otherwise

  ServerConnection(ServerPort port, Link link, ConnectionSelector selector) {
    this.port = port;
    this.link = link;
    this.selector = selector;
    this.limits = selector.limits();
  }

  ServerPort port() {
    return port;
  }

  Link link() {
    return link;
  }

  /** Encrypts what follows. For the selector, after the greeting. */
  TlsLink beginHandshake(ChannelIdentity identity) {
    TlsLink encrypted = TlsLink.server(link, identity);
    link = encrypted;
    enter(State.HANDSHAKE);
    return encrypted;
  }

  State state() {
    return state;
  }

  /** Prefers it until its first call: its client has said that it is for a stop. */
  void prefer(long now) {
    long until = now + StopLane.FIRST_CALL_NANOS;
    preferredUntil = until == 0 ? 1 : until;
  }

  /** Whether it is preferred. */
  boolean isPreferred(long now) {
    long until = preferredUntil;
    return until != 0 && now - until < 0;
  }

  /** How long it has been in its state without transfer, in nanoseconds. */
  long nanosInState(long now) {
    return now - since;
  }

  /** How long it may still be idle, in nanoseconds. */
  long idleRest(long now) {
    return ConnectionTimeouts.IDLE_NANOS - nanosInState(now);
  }

  /** As {@link #nanosInState(long)}; 0 if it is in another state by now. */
  synchronized long nanosInState(State expected, long now) {
    return state == expected ? now - since : 0;
  }

  /** How long the current request has been arriving, in nanoseconds. */
  long nanosOfRequest(long now) {
    return now - requestBegan;
  }

  /** See {@link org.dfra.river.access.MeteredRequest}. For the worker. */
  long takeBytes() {
    long before = bytesTaken;
    bytesTaken = link.bytes();
    return bytesTaken - before;
  }

  /** What arrived of a greeting or a request, while the selector has the connection. */
  byte[] partial() {
    return partial;
  }

  /**
   * Keeps what arrived of a greeting or a request, for the selector. What the link holds counts
   * too.
   *
   * @return false if it is more than may be kept
   */
  boolean keepPartial(ByteBuffer bytes) {
    if (!count(bytes.remaining() + link.held())) {
      return false;
    }
    byte[] copy = bytes.hasRemaining() ? new byte[bytes.remaining()] : NOTHING;
    bytes.get(copy);
    partial = copy;
    return true;
  }

  /** Nothing is kept any more: a worker has it, or it is discarded. */
  void forgetPartial() {
    boolean unused = count(0);
    partial = NOTHING;
  }

  private boolean count(int bytes) {
    int more = bytes - kept;
    if (more > 0 && !limits.take(Resource.PARTIAL_BYTES, link.peer(), more)) {
      return false;
    }
    if (more < 0) {
      limits.giveBack(Resource.PARTIAL_BYTES, link.peer(), -more);
    }
    kept = bytes;
    return true;
  }

  /** Begins a state. */
  synchronized void enter(State next) {
    long now = System.nanoTime();
    if (state == State.IDLE || state == State.WAITING) {
      requestBegan = now;
    }
    since = now;
    state = next;
  }

  /** Begins a state if it is in another one. Returns false if it is in none of these. */
  synchronized boolean enter(State expected, State next) {
    if (state != expected) {
      return false;
    }
    enter(next);
    return true;
  }

  /** Records that bytes were transferred. */
  void progress() {
    since = System.nanoTime();
  }

  /**
   * Prepares it for a worker.
   *
   * @param received the first block of a request at least, ready to be read from
   * @return false if its client has too many requests that are not complete
   */
  boolean assign(ByteBuffer received) throws IOException {
    preferredUntil = 0;
    if (!admit(received)) {
      return false;
    }
    ByteBuffer buffer = BufferPool.BLOCKS.take();
    buffer.put(received).flip();
    input = buffer;
    enter(State.RECEIVING);
    return true;
  }

  /** Undoes {@link #assign}: the worker has ended, or none is available. */
  void unassign() {
    if (input != null) {
      BufferPool.BLOCKS.giveBack(input);
      input = null;
    }
    releaseReceiver();
  }

  /** A request that is not complete may occupy its worker for long. */
  private boolean admit(ByteBuffer received) throws IOException {
    boolean isComplete = false;
    if (received.remaining() >= Block.HEADER_BYTES) {
      Block first = Block.decode(received.getInt(received.position()));
      isComplete =
          first.kind() != Block.Kind.PART
              && received.remaining() >= Block.HEADER_BYTES + first.length();
    }
    if (!isComplete) {
      isReceiver = limits.take(Resource.RECEIVERS, link.peer(), 1);
      return isReceiver;
    }
    return true;
  }

  private void releaseReceiver() {
    if (isReceiver) {
      isReceiver = false;
      limits.giveBack(Resource.RECEIVERS, link.peer(), 1);
    }
  }

  /** Serves the calls on this connection until there is none for a while. */
  @Override
  public void run() {
    @Nullable ByteBuffer output = null;
    boolean goesOn = false;
    try {
      ByteBuffer buffer = Objects.requireNonNull(input);
      output = BufferPool.BLOCKS.take();
      do {
        goesOn = serveOne(buffer, output);
        releaseReceiver();
      } while (goesOn && awaitNext(buffer));
    } catch (IOException e) {
      goesOn = false;
      LOG.log(Level.DEBUG, () -> "The connection of " + link.peer() + " ended: " + e);
    } catch (RuntimeException | Error e) {
      goesOn = false;
      LOG.log(Level.WARNING, "A call of " + link.peer() + " failed outside of its object.", e);
    } finally {
      unassign();
      if (output != null) {
        BufferPool.BLOCKS.giveBack(output);
      }
      if (mayWait) {
        mayWait = false;
        limits.giveBack(Resource.WAITING_WORKERS, link.peer(), 1);
      }
      giveBackWorker();
      if (goesOn) {
        selector.takeBack(this); // the last access: the selector has it now
      } else {
        close();
      }
    }
  }

  /**
   * Takes a thread for a request: one of those that are kept for stops, if there is no other.
   *
   * @param received what has arrived of the request, ready to be read from
   * @return false if there is none
   */
  boolean takeWorker(ByteBuffer received) {
    if (limits.take(Resource.WORKERS, link.peer(), 1)) {
      return true;
    }
    StopLane.@Nullable Share its = StopLane.isStop(received) ? StopLane.Share.of(link) : null;
    if (its == null || !selector.stops().take(its)) {
      return false;
    }
    share = its;
    return true;
  }

  /** Undoes {@link #takeWorker}. */
  void giveBackWorker() {
    StopLane.@Nullable Share its = share;
    if (its == null) {
      limits.giveBack(Resource.WORKERS, link.peer(), 1);
    } else {
      share = null;
      selector.stops().giveBack(its);
    }
  }

  /** Returns whether further calls may follow on this connection. */
  private boolean serveOne(ByteBuffer buffer, ByteBuffer output) throws IOException {
    InboundCall call = new InboundCall(this, buffer, output);
    if (call.isForCollector()) {
      call.refuseCollector();
      return call.answer() && call.skipRest(MAX_SKIPPED);
    }
    enter(State.EXECUTING);
    TransportTraffic.countCallServed();
    try {
      CurrentIdentity.runAs(port.identity(), () -> port.dispatcher().dispatch(call));
      boolean unused = Thread.interrupted(); // an object may leave it set; it closes a channel
      if (!call.answer()) {
        return false;
      }
    } finally {
      call.ended();
    }
    requestBegan = System.nanoTime(); // it may have executed for long
    enter(State.RECEIVING);
    return call.skipRest(MAX_SKIPPED);
  }

  /** Waits for the next request. Returns false if the selector is to wait for it. */
  private boolean awaitNext(ByteBuffer buffer) throws IOException {
    if (port.isClosed()) {
      return false;
    }
    if (!buffer.hasRemaining()) {
      if (share != null) {
        return false; // its thread is for another stop
      }
      if (!mayWait && !limits.take(Resource.WAITING_WORKERS, link.peer(), 1)) {
        return false;
      }
      mayWait = true;
      enter(State.WAITING);
      buffer.clear();
      int count = link.read(buffer);
      buffer.flip();
      if (count < 0) {
        if (state == State.CLOSING) { // the selector has ended the wait
          announceEnd();
          return false;
        }
        throw MessageInput.ended();
      }
      if (!enter(State.WAITING, State.RECEIVING)) {
        return refuse(buffer); // the selector has ended the wait
      }
    }
    requestBegan = System.nanoTime();
    if (!skipPauses(buffer)) {
      return false;
    }
    if (port.isClosed() || share != null || !admit(buffer)) { // closed since the check above
      enter(State.CLOSING);
      return refuse(buffer);
    }
    return true;
  }

  /** Discards a request that is not executed, and informs the client. */
  private boolean refuse(ByteBuffer request) throws IOException {
    request.clear().flip();
    announceEnd();
    return false;
  }

  /** Returns whether a request follows at once. */
  private boolean skipPauses(ByteBuffer buffer) throws IOException {
    while (true) {
      while (buffer.remaining() < Block.HEADER_BYTES) {
        buffer.compact();
        try {
          receive(buffer);
        } finally {
          buffer.flip();
        }
      }
      Block next = Block.decode(buffer.getInt(buffer.position()));
      if (next.kind() != Block.Kind.PAUSE) {
        return true;
      }
      buffer.position(buffer.position() + Block.HEADER_BYTES);
      if (!buffer.hasRemaining()) {
        return false;
      }
    }
  }

  /** Waits for more of a request. */
  void receive(ByteBuffer buffer) throws IOException {
    State before = state;
    if (before == State.EXECUTING) {
      enter(State.RECEIVING);
    }
    if (link.read(buffer) < 0) {
      throw MessageInput.ended();
    }
    progress();
    if (before == State.EXECUTING) {
      enter(State.EXECUTING);
    }
  }

  /** Sends a block of the response. */
  void send(ByteBuffer block) throws IOException {
    boolean unused = Thread.interrupted(); // by the object; it would close the channel
    enter(State.ANSWERING);
    link.write(block);
    progress();
  }

  /**
   * Ends it so that the client does not take a request for executed that is not. For the selector,
   * which must not wait: if a worker waits for the next request, that informs the client.
   *
   * @param expected {@code IDLE} or {@code WAITING}
   * @return false if it is in another state
   */
  boolean beginClosing(State expected) throws IOException {
    if (!enter(expected, State.CLOSING)) {
      return false;
    }
    if (expected == State.WAITING) {
      link.endInput();
    } else {
      announceEnd();
    }
    return true;
  }

  private void announceEnd() throws IOException {
    ByteBuffer block = ByteBuffer.allocate(Block.HEADER_BYTES);
    block.putInt(Block.encode(Block.Kind.CLOSING, 0)).flip();
    if (link.write(block) < Block.HEADER_BYTES) {
      throw new IOException("the client takes no more bytes");
    }
    link.endOutput();
  }

  /** Closes it. */
  void close() {
    try {
      link.close();
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "The connection of " + link.peer() + " was not closed in order.", e);
    }
    selector.forget(this);
  }
}
