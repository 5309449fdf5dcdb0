package org.dfra.river.transport;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectableChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.transport.ConnectionLimits.Resource;
import org.dfra.river.transport.ServerConnection.State;
import org.jspecify.annotations.Nullable;

/**
 * Accepts the connections of this virtual machine and has those on which no call is made. When the
 * first block of a request is complete, a worker takes the connection: a client that sends half a
 * block never occupies a thread.
 *
 * <p>Threads: one daemon, {@code dfra-connections}, from the first export on, which everything here
 * is confined to unless it says otherwise, and the workers {@code dfra-worker-}number, which end
 * after half a minute without a call.
 */
final class ConnectionSelector {

  private static final System.Logger LOG = System.getLogger(ConnectionSelector.class.getName());

  /** How often connections are checked while calls are made. */
  private static final long TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

  private final Selector selector;
  private final ConnectionLimits limits = new ConnectionLimits();
  private final Set<ServerConnection> connections = ConcurrentHashMap.newKeySet();
  private final ConcurrentLinkedQueue<Runnable> tasks = new ConcurrentLinkedQueue<>();
  private final ByteBuffer scratch = ByteBuffer.allocateDirect(Block.BLOCK_BYTES);

  private final StopLane stops = new StopLane();

  /** Limited by {@link Resource#WORKERS} and {@link StopLane}. */
  private final Executor workers = DaemonPool.create("dfra-worker-");

  private final Handshakes handshakes = new Handshakes(this);
  private final ConnectionAcceptor acceptor;
  private volatile long nextCheck = System.nanoTime();

  /** Have received more than was read. */
  private final Set<SelectionKey> ready = new LinkedHashSet<>();

  /** Whose lists of revoked certificates cause a check. */
  private final Set<ChannelIdentity> identities = Collections.newSetFromMap(new WeakHashMap<>());

  /** The one of this virtual machine. */
  private static final class Holder {
    static final ConnectionSelector INSTANCE = start();

    private static ConnectionSelector start() {
      try {
        ConnectionSelector made = new ConnectionSelector(Selector.open());
        Thread thread = new Thread(made::run, "dfra-connections");
        thread.setDaemon(true);
        thread.setContextClassLoader(null);
        thread.start();
        return made;
      } catch (IOException e) {
        throw new UncheckedIOException("this process cannot wait for connections", e);
      }
    }
  }

  private ConnectionSelector(Selector selector) {
    this.selector = selector;
    this.acceptor = new ConnectionAcceptor(this, limits, connections);
  }

  static ConnectionSelector instance() {
    return Holder.INSTANCE;
  }

  /** What clients may use. For any thread. */
  ConnectionLimits limits() {
    return limits;
  }

  /** What is kept for stops. For any thread. */
  StopLane stops() {
    return stops;
  }

  /** Accepts the connections of a port. For any thread. */
  void listen(ServerPort port) {
    submit(
        () -> {
          @Nullable ChannelIdentity identity = port.identity();
          if (identity != null && identities.add(identity)) {
            identity.addRevocationListener(this::checkNow);
          }
          for (ServerSocketChannel each : port.channels()) {
            try {
              each.register(selector, SelectionKey.OP_ACCEPT, port);
            } catch (ClosedChannelException e) {
              LOG.log(Level.DEBUG, "A port was closed at once.", e);
            }
          }
        });
  }

  /** Waits for the next request of a connection that a worker served. For any thread. */
  void takeBack(ServerConnection connection) {
    submit(() -> register(connection));
  }

  /**
   * Ends the connections to a port that is closed. For any thread but the selector's. When it
   * returns, the port can be listened on again: Java frees it only after another selection.
   */
  void closeConnections(ServerPort port) {
    CompletableFuture<Boolean> freed = new CompletableFuture<>();
    submit(
        () -> {
          try {
            for (ServerConnection each : connections) {
              if (each.port() == port) {
                endGently(each);
              }
            }
            int unused = selector.selectNow();
          } catch (IOException e) {
            LOG.log(Level.DEBUG, "A port is freed later.", e);
          } finally {
            freed.complete(true);
          }
        });
    boolean unused = freed.join();
  }

  /** Forgets a connection that is closed. For any thread. */
  void forget(ServerConnection connection) {
    if (connections.remove(connection)) {
      connection.forgetPartial();
      limits.giveBack(Resource.CONNECTIONS, connection.link().peer(), 1);
    }
  }

  /** Connections may be idle for a minute before the next check. For any thread. */
  private void checkNow() {
    submit(() -> nextCheck = System.nanoTime());
  }

  /** Runs a task on the selector's thread. For any thread. */
  void submit(Runnable task) {
    tasks.add(task);
    selector.wakeup();
  }

  private void run() {
    while (true) {
      try {
        selectOnce();
      } catch (ClosedSelectorException e) {
        throw e; // nothing closes it
      } catch (IOException | RuntimeException | Error e) { // all other connections need this thread
        LOG.log(Level.ERROR, "Waiting for remote calls failed; it goes on.", e);
      }
    }
  }

  private void selectOnce() throws IOException {
    long rest = nextCheck - System.nanoTime();
    if (connections.isEmpty() && !acceptor.isPaused()) {
      selector.select();
    } else if (rest > 0 && ready.isEmpty()) {
      selector.select(TimeUnit.NANOSECONDS.toMillis(rest) + 1);
    } else {
      selector.selectNow();
    }
    List<SelectionKey> again = List.copyOf(ready);
    ready.clear();
    for (@Nullable Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
      task.run();
    }
    for (SelectionKey key : selector.selectedKeys()) {
      handle(key);
    }
    selector.selectedKeys().clear();
    again.stream().filter(SelectionKey::isValid).forEach(this::handle);
    long now = System.nanoTime();
    if (now - nextCheck >= 0) {
      nextCheck = now + checkAll(now);
    }
  }

  /** Takes what a connection has received. */
  void handle(SelectionKey key) {
    if (key.attachment() instanceof ServerPort port) {
      acceptor.accept(key, port);
      checkSoon();
      return;
    }
    ServerConnection connection = (ServerConnection) key.attachment();
    try {
      if (connection.state() == State.HANDSHAKE) {
        handshakes.proceed(key, connection);
        return;
      }
      read(key, connection);
      if (key.isValid() && connection.link().hasReceived()) {
        ready.add(key); // when the others had their turn
      }
    } catch (IOException | CancelledKeyException e) {
      LOG.log(Level.DEBUG, () -> "The connection of " + connection.link().peer() + " ended: " + e);
      connection.close();
    } catch (RuntimeException | Error e) {
      LOG.log(Level.WARNING, "A connection of " + connection.link().peer() + " failed.", e);
      connection.close();
    }
  }

  /** Takes a connection that was accepted. */
  void adopt(ServerConnection connection) throws IOException {
    connections.add(connection);
    connection.link().channel().register(selector, SelectionKey.OP_READ, connection);
    checkSoon();
  }

  private void register(ServerConnection connection) {
    try {
      connection.link().setBlocking(false);
      SelectableChannel channel = connection.link().channel();
      if (channel.keyFor(selector) != null) { // a worker had it for a part of this round only
        int unused = selector.selectNow(); // forgets the key that was cancelled for the worker
      }
      SelectionKey key = channel.register(selector, SelectionKey.OP_READ, connection);
      if (connection.state() != State.CLOSING) {
        connection.enter(State.IDLE);
        if (connection.port().isClosed()) {
          endGently(connection);
        }
      }
      checkSoon();
      if (connection.link().held() > 0) { // half a request has a limit, too
        handle(key);
      }
    } catch (IOException | CancelledKeyException e) {
      LOG.log(Level.DEBUG, "A connection ended while it was idle.", e);
      connection.close();
    }
  }

  /** When connections are checked next, in nanoseconds from now. For any thread. */
  long nanosUntilCheck() {
    return nextCheck - System.nanoTime();
  }

  private void checkSoon() {
    nextCheck = Math.min(nextCheck, System.nanoTime() + TICK_NANOS);
  }

  private void read(SelectionKey key, ServerConnection connection) throws IOException {
    scratch.clear().put(connection.partial());
    int count = connection.link().read(scratch);
    scratch.flip();
    if (count < 0) {
      connection.close();
      return;
    }
    switch (connection.state()) {
      case GREETING -> greet(connection);
      case IDLE, PARTIAL -> receive(key, connection);
      case CLOSING -> LOG.log(Level.TRACE, "A connection that is closed received more.");
      default -> throw new IllegalStateException("a worker has the connection");
    }
  }

  private void greet(ServerConnection connection) throws IOException {
    if (scratch.remaining() < Greeting.CLIENT_BYTES) {
      keep(connection);
      return;
    }
    long now = System.nanoTime();
    if (Greeting.isForStop(scratch)
        && StopLane.hasPlace(connections, connection.link().peer(), now)) {
      connection.prefer(now);
    }
    Greeting.Answer answer =
        Greeting.readClient(scratch, connection.port().id(), connection.port().identity() != null);
    if (connection.link().write(Greeting.server(answer)) != Greeting.SERVER_BYTES
        || answer != Greeting.Answer.WELCOME
        || scratch.hasRemaining()) { // a client waits for the greeting
      connection.close();
      return;
    }
    keep(connection);
    @Nullable ChannelIdentity identity = connection.port().identity();
    if (identity != null) {
      TlsLink unused = connection.beginHandshake(identity);
      checkSoon();
      return;
    }
    connection.enter(State.IDLE);
    if (connection.port().isClosed()) {
      endGently(connection);
    }
  }

  private void keep(ServerConnection connection) throws IOException {
    if (!connection.keepPartial(scratch)) {
      acceptor.logFull(connection.link().peer() + " has too many unfinished calls; one is refused");
      throw new IOException("too many unfinished calls");
    }
    connection.progress();
  }

  private void receive(SelectionKey key, ServerConnection connection) throws IOException {
    while (scratch.remaining() >= Block.HEADER_BYTES) {
      Block block = Block.decode(scratch.getInt(scratch.position()));
      if (block.kind() == Block.Kind.CLOSING) {
        throw new IOException("a client sent a block that only servers send");
      }
      int length = Block.HEADER_BYTES + block.length();
      if (block.kind() == Block.Kind.PAUSE) {
        scratch.position(scratch.position() + length);
      } else if (scratch.remaining() >= length) {
        serve(key, connection);
        return;
      } else {
        break;
      }
    }
    State state = connection.state();
    boolean isIdle = !scratch.hasRemaining() && connection.link().held() == 0;
    if (isIdle && state == State.IDLE) {
      return; // it has paused again, which prolongs nothing
    }
    keep(connection);
    if (isIdle) {
      connection.enter(State.IDLE);
    } else if (state == State.IDLE) {
      connection.enter(State.PARTIAL);
      checkSoon();
    }
  }

  private void serve(SelectionKey key, ServerConnection connection) throws IOException {
    boolean isOpen = !connection.port().isClosed();
    if (!isOpen || !connection.takeWorker(scratch)) {
      refuse(connection, isOpen);
      return;
    }
    boolean done = false;
    try {
      if (!connection.assign(scratch)) {
        refuse(connection, true);
        return;
      }
      connection.forgetPartial();
      key.cancel();
      connection.link().setBlocking(true);
      workers.execute(connection);
      done = true;
    } finally {
      if (!done) {
        connection.unassign();
        connection.giveBackWorker();
      }
    }
    checkSoon();
  }

  private void refuse(ServerConnection connection, boolean isTooMuch) {
    if (isTooMuch) {
      acceptor.logFull(connection.link().peer() + " makes too many calls at once; one is refused");
    }
    connection.forgetPartial(); // what comes now is discarded
    connection.enter(State.IDLE);
    endGently(connection);
  }

  /** Ends a connection so that no client takes a request for executed that is not. */
  void endGently(ServerConnection connection) {
    try {
      State state = connection.state();
      if (state == State.IDLE || state == State.WAITING) {
        boolean unused = connection.beginClosing(state);
        checkSoon();
      } else if (state == State.GREETING || state == State.HANDSHAKE || state == State.PARTIAL) {
        connection.close();
      }
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "A connection ended before it was closed.", e);
      connection.close();
    }
  }

  /** Ends what takes too long. Returns the nanoseconds until the next check. */
  private long checkAll(long now) {
    acceptor.resume(selector.keys());
    long next = ConnectionTimeouts.IDLE_NANOS;
    for (ServerConnection each : connections) {
      @Nullable ChannelPeer client = each.link().partner();
      if (client != null && client.isRevoked()) {
        LOG.log(
            Level.INFO,
            () -> client + " (" + each.link().peer() + ") is cut off: its certificate was revoked");
        each.close();
        continue;
      }
      switch (ConnectionTimeouts.check(each, now)) {
        case CLOSE -> {
          LOG.log(
              Level.DEBUG,
              () -> "The connection of " + each.link().peer() + " is given up: " + each.state());
          each.close();
        }
        case END -> endGently(each);
        case KEEP -> {
          // in time
        }
      }
      next = Math.min(next, each.state() == State.IDLE ? each.idleRest(now) : TICK_NANOS);
    }
    return Math.max(next, TICK_NANOS);
  }
}
