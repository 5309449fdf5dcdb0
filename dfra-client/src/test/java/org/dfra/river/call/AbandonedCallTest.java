package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Collection;
import java.util.concurrent.CountDownLatch;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.OutboundRequestIterator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A call that leaves in the very moment in which it is given up may have run, and says so. */
@Timeout(60)
class AbandonedCallTest {

  /** What is called. */
  public interface Service extends Remote {
    void move() throws RemoteException;
  }

  private final LateRequest request = new LateRequest();

  /** Its deadline is long enough for a busy computer to load what a first call needs. */
  @Test
  void aCallThatLeavesAtItsDeadlineSaysThatItMayHaveRun() {
    Service service = service(Duration.ofSeconds(3));
    assertThatThrownBy(service::move)
        .isInstanceOfSatisfying(
            DeadlineExceededException.class, e -> assertThat(e.mayHaveRun()).isTrue());
  }

  @Test
  void aCallThatLeavesWhenItsCallerIsInterruptedSaysThatItMayHaveRun() {
    Service service = service(Duration.ofSeconds(30));
    Thread caller = Thread.currentThread();
    Thread interrupting =
        new Thread(
            () -> {
              awaitUninterruptibly(request.asked);
              caller.interrupt();
            });
    interrupting.start();
    assertThatThrownBy(service::move)
        .isInstanceOf(CallInterruptedException.class)
        .hasMessageContaining("it may have run");
    assertThat(Thread.interrupted()).isTrue();
  }

  private Service service(Duration deadline) {
    return (Service)
        DeadlineILFactory.proxy(
            new Endpoint(request), deadline, Service.class.getClassLoader(), Service.class);
  }

  private static void awaitUninterruptibly(CountDownLatch latch) {
    while (true) {
      try {
        latch.await();
        return;
      } catch (InterruptedException e) {
        // a connection cannot be interrupted either
      }
    }
  }

  /** A request whose first bytes leave between the end of the caller's patience and the abort. */
  private static final class LateRequest implements OutboundRequest {

    private final CountDownLatch asked = new CountDownLatch(1);
    private final CountDownLatch aborted = new CountDownLatch(1);
    private volatile boolean hasLeft;

    @Override
    public void abort() {
      hasLeft = true;
      aborted.countDown();
    }

    @Override
    public boolean getDeliveryStatus() {
      return hasLeft;
    }

    @Override
    public OutputStream getRequestOutputStream() {
      return new ByteArrayOutputStream();
    }

    @Override
    public InputStream getResponseInputStream() {
      return new InputStream() {
        @Override
        public int read() throws IOException {
          asked.countDown();
          awaitUninterruptibly(aborted);
          throw new IOException("aborted");
        }
      };
    }

    @Override
    @SuppressWarnings("rawtypes") // as River declares it
    public void populateContext(Collection context) {}

    @Override
    public InvocationConstraints getUnfulfilledConstraints() {
      return InvocationConstraints.EMPTY;
    }
  }

  private record Endpoint(LateRequest request) implements ObjectEndpoint {

    @Override
    public OutboundRequestIterator newCall(InvocationConstraints constraints) {
      return new OutboundRequestIterator() {
        private boolean isFirst = true;

        @Override
        public boolean hasNext() {
          return isFirst;
        }

        @Override
        public OutboundRequest next() {
          isFirst = false;
          return request;
        }
      };
    }

    @Override
    public RemoteException executeCall(OutboundRequest call) {
      return null;
    }
  }
}
