package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.rmi.server.ExportException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Phoenix's port is in use when it starts, for a moment or for good. */
class TakenPortTest {

  @TempDir Path folder;

  @Test
  void startsOnceTheProcessThatInheritedThePortHasClosedIt() throws Exception {
    try (InVmPhoenix phoenix = new InVmPhoenix(folder);
        ServerSocket inherited = listenAt(phoenix.port())) {
      CompletableFuture<Void> closed =
          CompletableFuture.runAsync(
              () -> close(inherited),
              CompletableFuture.delayedExecutor(300, TimeUnit.MILLISECONDS));
      phoenix.start();
      assertThat(closed).isDone();
      assertThat(phoenix.admin().groupStatus()).isEmpty();
    }
  }

  @Test
  void saysInTheEndThatAnotherPhoenixMayHaveIt() throws Exception {
    try (InVmPhoenix phoenix = new InVmPhoenix(folder);
        ServerSocket other = listenAt(phoenix.port())) {
      assertThatThrownBy(phoenix::start)
          .isInstanceOf(ExportException.class)
          .hasNoCause()
          .hasMessage(
              "Phoenix's port cannot be opened (Address already in use); another phoenix may be"
                  + " running on this host: stop it, or give this one another port");
      assertThat(other.isClosed()).isFalse();
    }
  }

  private static ServerSocket listenAt(int port) throws Exception {
    return new ServerSocket(port, 1, InetAddress.getByName("127.0.0.1"));
  }

  private static void close(ServerSocket socket) {
    try {
      socket.close();
    } catch (java.io.IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
