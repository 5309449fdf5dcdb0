package org.dfra.testing;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A simulated serial cable from a robot's host to a device that is simulated on another host. The
 * bytes pass through a socket in the file system, which the hosts of {@link NetworkNamespaceHosts}
 * share: they use no network, so the switch cannot cut them, as it cannot cut a real serial line.
 *
 * <pre>
 *   driver --tcp, loopback--&gt; {@link #robotEnd} --file--&gt; {@link #deviceEnd} --tcp, loopback--&gt; device
 * </pre>
 *
 * <p>Each end has a thread that accepts connections, and two for each of them; {@link #close} ends
 * all.
 */
public final class SerialCable implements AutoCloseable {

  private static final int BUFFER = 4096;

  private final ServerSocketChannel from;
  private final SocketAddress to;
  private final Set<SocketChannel> open = ConcurrentHashMap.newKeySet();

  private SerialCable(ServerSocketChannel from, SocketAddress to) {
    this.from = from;
    this.to = to;
    thread("cable to " + to, this::accept);
  }

  /**
   * The end at the device.
   *
   * @param socket a file that does not exist yet
   * @param link the device's address, {@code tcp://127.0.0.1:port}
   */
  public static SerialCable deviceEnd(Path socket, String link) throws IOException {
    ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
    server.bind(UnixDomainSocketAddress.of(socket));
    int port = Integer.parseInt(link.substring(link.lastIndexOf(':') + 1));
    return new SerialCable(server, new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
  }

  /** The end at the robot, on the host of the calling process. */
  public static SerialCable robotEnd(Path socket) throws IOException {
    ServerSocketChannel server = ServerSocketChannel.open();
    server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    return new SerialCable(server, UnixDomainSocketAddress.of(socket));
  }

  /** The driver's address of the end at the robot. */
  public String link() throws IOException {
    InetSocketAddress at = (InetSocketAddress) from.getLocalAddress();
    return "tcp://" + at.getAddress().getHostAddress() + ":" + at.getPort();
  }

  private void accept() {
    while (from.isOpen()) {
      try {
        SocketChannel near = from.accept();
        open.add(near);
        connect(near);
      } catch (IOException e) {
        if (from.isOpen()) {
          System.err.println("cable to " + to + ": " + e); // the driver tries again
        }
      }
    }
  }

  private void connect(SocketChannel near) throws IOException {
    try {
      SocketChannel far = SocketChannel.open(to);
      open.add(far);
      thread("cable to " + to + ", out", () -> pass(near, far));
      thread("cable to " + to + ", in", () -> pass(far, near));
    } catch (IOException e) {
      end(near);
      throw e;
    }
  }

  /** Copies until one of them ends, then closes both. */
  private void pass(SocketChannel source, SocketChannel sink) {
    ByteBuffer buffer = ByteBuffer.allocate(BUFFER);
    try {
      while (source.read(buffer) >= 0) {
        buffer.flip();
        while (buffer.hasRemaining()) {
          sink.write(buffer);
        }
        buffer.clear();
      }
    } catch (IOException e) {
      open.remove(source); // one of them is closed, which ends the other
    } finally {
      end(source);
      end(sink);
    }
  }

  private void end(SocketChannel channel) {
    open.remove(channel);
    try {
      channel.close();
    } catch (IOException e) {
      System.err.println("cable to " + to + ": " + e);
    }
  }

  private static void thread(String name, Runnable role) {
    Thread thread = new Thread(role, name);
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void close() throws IOException {
    from.close();
    open.forEach(this::end);
  }
}
