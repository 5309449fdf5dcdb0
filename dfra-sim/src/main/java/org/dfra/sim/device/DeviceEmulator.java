package org.dfra.sim.device;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * Serves an emulated device on a TCP port of the loopback interface, as a serial device server
 * does.
 *
 * <p>It has one client at a time. A new client replaces one that has sent nothing for 3 s, so that
 * a computer that lost its network reconnects. While the old client sends, a new one is
 * disconnected at once, so that it cannot cut off the driver. Output is lost while there is no
 * client or while the client does not read, as on a serial line; a device that {@linkplain
 * SerialDevice#buffersOutput buffers} its output is polled for more when the client has read what
 * came before. Input from the client is paced by the device's baud rate too. While the {@link
 * #cable} is unplugged, every connection is closed.
 *
 * <p>{@link #start} opens the port and starts one thread, {@code name emulator port}, which owns
 * device and connections; {@link #close} stops it, closes everything, and then returns. Both are
 * idempotent.
 */
public class DeviceEmulator implements AutoCloseable {

  /** Real time between two polls of the clock. */
  private static final int POLL_INTERVAL_MILLIS = 5;

  /** Maximum chunks per poll from a device that buffers its output. */
  private static final int MOST_PIECES = 256;

  /** Real time after its last bytes for which a client is not replaced. */
  private static final long KEEPS_PLACE_NANOS = 3_000_000_000L;

  private final String name;
  private final int requestedPort;
  private final InstantSource clock;
  private final Cable cable;

  @GuardedBy("this")
  private boolean begun;

  @GuardedBy("this")
  private boolean closed;

  @GuardedBy("this")
  private @Nullable ServerSocketChannel server;

  @GuardedBy("this")
  private @Nullable Selector selector;

  @GuardedBy("this")
  private @Nullable Thread thread;

  private volatile boolean running;

  /**
   * @param name the device's name, for its thread
   * @param port TCP port on the loopback interface, 0 to 65535; 0 is any free one
   * @param device the device; the emulator's thread owns it from now on
   * @param clock gives the time that it reports and by which it paces its bytes; may run at any
   *     speed or be stepped
   */
  public DeviceEmulator(String name, int port, SerialDevice device, InstantSource clock) {
    if (port < 0 || port > 65535) {
      throw new IllegalArgumentException("port " + port + " is outside 0 to 65535");
    }
    this.name = name;
    this.requestedPort = port;
    this.cable = new Cable(device);
    this.clock = clock;
  }

  /**
   * Opens the port and starts.
   *
   * @throws IOException if the port cannot be opened
   */
  public final synchronized void start() throws IOException {
    if (closed) {
      throw new IllegalStateException("this emulator was closed; create a new one");
    }
    if (begun) {
      return;
    }
    ServerSocketChannel listening = ServerSocketChannel.open();
    try {
      listening.setOption(StandardSocketOptions.SO_REUSEADDR, true);
      listening.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), requestedPort));
      listening.configureBlocking(false);
      Selector chosen = Selector.open();
      SelectionKey unused = listening.register(chosen, SelectionKey.OP_ACCEPT);
      server = listening;
      selector = chosen;
      begun = true;
      running = true;
      Thread worker = new Thread(() -> run(listening, chosen), name + " emulator " + port());
      thread = worker;
      worker.start();
    } catch (IOException e) {
      listening.close();
      throw new IOException(
          "port "
              + requestedPort
              + " of the loopback interface cannot be opened ("
              + e.getMessage()
              + "); choose another, or 0 for any free one",
          e);
    }
  }

  /**
   * The TCP port on which it listens.
   *
   * @throws IllegalStateException if it does not listen
   */
  public final synchronized int port() {
    if (server == null || !server.isOpen()) {
      throw new IllegalStateException("the emulator does not listen yet; start it first");
    }
    return server.socket().getLocalPort();
  }

  /** The link for a driver: {@code tcp://127.0.0.1:port}. */
  public final String url() {
    return "tcp://" + InetAddress.getLoopbackAddress().getHostAddress() + ":" + port();
  }

  /** The cable to the device, for fault injection. */
  public final Cable cable() {
    return cable;
  }

  /** Waits until it has been closed. */
  public final void await() throws InterruptedException {
    Thread worker;
    synchronized (this) {
      worker = thread;
    }
    if (worker != null) {
      worker.join();
    }
  }

  @Override
  public final void close() {
    Thread worker;
    synchronized (this) {
      closed = true;
      running = false;
      if (selector != null) {
        selector.wakeup();
      }
      worker = thread;
    }
    if (worker == null || worker == Thread.currentThread()) {
      return;
    }
    try {
      worker.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void run(ServerSocketChannel listening, Selector chosen) {
    Client client = null;
    try (listening;
        chosen) {
      while (running) {
        chosen.select(POLL_INTERVAL_MILLIS);
        chosen.selectedKeys().clear();
        SocketChannel caller = listening.accept();
        if (caller != null && cable.isPulled()) {
          caller.close();
        } else if (caller != null) {
          client = replace(client, caller, chosen);
        }
        client = exchange(client, clock.instant());
      }
    } catch (IOException e) {
      throw new UncheckedIOException("the emulator cannot continue: " + e.getMessage(), e);
    } finally {
      if (client != null) {
        client.close();
      }
    }
  }

  private Client replace(@Nullable Client old, SocketChannel caller, Selector chosen)
      throws IOException {
    if (old != null) {
      Instant now = clock.instant();
      if (old.readAll(bytes -> cable.send(bytes, now)) && old.isActive()) {
        caller.close();
        return old;
      }
      old.close();
      cable.disconnected();
    }
    cable.connected();
    return new Client(caller, chosen);
  }

  /** One poll: passes bytes from the client to the device and from the device to the client. */
  private @Nullable Client exchange(@Nullable Client client, Instant now) {
    if (client == null) {
      byte[] unused = cable.pass(now);
      return null;
    }
    boolean isThere = client.read(bytes -> cable.send(bytes, now));
    if (isThere
        && !cable.isPulled()
        && (cable.buffersOutput()
            ? sendAll(client, now)
            : client.write(ByteBuffer.wrap(cable.pass(now))))) {
      return client;
    }
    client.close();
    cable.disconnected();
    return null;
  }

  /**
   * Sends all pending output, as far as the network accepts it. False when the client has
   * disconnected.
   */
  private boolean sendAll(Client client, Instant now) {
    for (int piece = 0; piece < MOST_PIECES; piece++) {
      if (!client.unsent.hasRemaining()) {
        client.unsent = ByteBuffer.wrap(cable.pass(now));
      }
      if (!client.unsent.hasRemaining()) {
        return true;
      }
      if (!client.write(client.unsent)) {
        return false;
      }
      if (client.unsent.hasRemaining()) {
        return true;
      }
    }
    return true;
  }

  /** A connection, non-blocking. */
  private static final class Client {

    private final SocketChannel channel;
    private final ByteBuffer in = ByteBuffer.allocate(1024);

    /** Output of a buffering device that the network has not accepted yet. */
    private ByteBuffer unsent = ByteBuffer.allocate(0);

    private boolean hasSent;
    private long lastSent;

    Client(SocketChannel channel, Selector selector) throws IOException {
      this.channel = channel;
      channel.configureBlocking(false);
      channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
      SelectionKey unused = channel.register(selector, SelectionKey.OP_READ);
    }

    /** Reads input; false when the client has disconnected. */
    boolean read(Consumer<byte[]> sink) {
      try {
        in.clear();
        int count = channel.read(in);
        if (count > 0) {
          hasSent = true;
          lastSent = System.nanoTime();
          sink.accept(Arrays.copyOf(in.array(), count));
        }
        return count >= 0;
      } catch (IOException e) {
        return false;
      }
    }

    /** Reads all input: pending input hides a disconnection. */
    boolean readAll(Consumer<byte[]> sink) {
      boolean[] isMore = new boolean[1];
      boolean isThere;
      do {
        isMore[0] = false;
        isThere =
            read(
                bytes -> {
                  isMore[0] = true;
                  sink.accept(bytes);
                });
      } while (isThere && isMore[0]);
      return isThere;
    }

    /** Whether it has sent something in the last seconds. */
    boolean isActive() {
      return hasSent && System.nanoTime() - lastSent < KEEPS_PLACE_NANOS;
    }

    /**
     * Sends what the network accepts now and keeps the rest. False when the client has
     * disconnected.
     */
    boolean write(ByteBuffer out) {
      try {
        if (out.hasRemaining()) {
          channel.write(out);
        }
        return true;
      } catch (IOException e) {
        return false;
      }
    }

    void close() {
      try {
        channel.close();
      } catch (IOException e) {
        // it is disconnected either way
      }
    }
  }
}
