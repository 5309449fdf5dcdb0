package org.dfra.sim.device;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/** A bad cable: passes bytes between a driver and a device, or does not. For tests. */
final class Relay implements AutoCloseable {

  private final ServerSocket server;
  private final int target;
  private final List<Socket> sockets = new CopyOnWriteArrayList<>();
  private volatile boolean cut;
  private volatile boolean silent;
  private volatile @Nullable Random garbage;

  Relay(int target) throws IOException {
    this.target = target;
    this.server = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
    spawn(this::accept);
  }

  String url() {
    return "tcp://127.0.0.1:" + server.getLocalPort();
  }

  /** Breaks every connection and lets none last. */
  void cut() {
    cut = true;
    sockets.forEach(Relay::end);
    sockets.clear();
  }

  void restore() {
    cut = false;
  }

  /** Connections stay, but nothing from the device arrives. */
  void silence(boolean on) {
    silent = on;
  }

  /** Puts random bytes before every piece that arrives; null stops that. */
  void garbage(@Nullable Random random) {
    garbage = random;
  }

  @Override
  public void close() throws IOException {
    cut();
    server.close();
  }

  private void accept() {
    try {
      while (true) {
        Socket driver = server.accept();
        if (cut) {
          driver.close();
          continue;
        }
        Socket device = new Socket(InetAddress.getLoopbackAddress(), target);
        sockets.add(driver);
        sockets.add(device);
        spawn(() -> pass(driver, device, false));
        spawn(() -> pass(device, driver, true));
      }
    } catch (IOException e) {
      // closed
    }
  }

  private void pass(Socket from, Socket to, boolean fromDevice) {
    byte[] buffer = new byte[256];
    try (from;
        to) {
      InputStream in = from.getInputStream();
      OutputStream out = to.getOutputStream();
      for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
        if (fromDevice && silent) {
          continue;
        }
        Random random = garbage;
        if (fromDevice && random != null && random.nextInt(3) == 0) {
          byte[] storm = new byte[random.nextInt(2000)];
          random.nextBytes(storm);
          out.write(storm);
        }
        out.write(buffer, 0, count);
      }
    } catch (IOException e) {
      // cut
    }
  }

  private static void end(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      // it is gone either way
    }
  }

  private static void spawn(Runnable work) {
    Thread thread = new Thread(work, "relay");
    thread.setDaemon(true);
    thread.start();
  }
}
