package org.dfra.core.audit;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;

/** Files on a disk that can be full or slow. */
final class FaultyFiles implements AppendFile.Opener {

  private volatile boolean isFull;
  private volatile CountDownLatch open = new CountDownLatch(0);

  void setFull(boolean full) {
    isFull = full;
  }

  /** From now on, writes wait until the result is counted down. */
  CountDownLatch block() {
    CountDownLatch blocked = new CountDownLatch(1);
    open = blocked;
    return blocked;
  }

  @Override
  public AppendFile open(Path path) throws IOException {
    AppendFile real = AppendFile.open(path);
    return new AppendFile() {
      @Override
      public void append(byte[] bytes) throws IOException {
        try {
          open.await();
        } catch (InterruptedException e) {
          throw new IOException(e);
        }
        if (isFull) {
          real.append(Arrays.copyOf(bytes, bytes.length / 2));
          throw new IOException("No space left on device");
        }
        real.append(bytes);
      }

      @Override
      public void truncate(long size) throws IOException {
        real.truncate(size);
      }

      @Override
      public void force() throws IOException {
        real.force();
      }

      @Override
      public void close() throws IOException {
        real.close();
      }
    };
  }
}
