package org.dfra.river.call;

import java.rmi.RemoteException;
import java.time.Duration;
import org.dfra.directory.ExecutionCertainty;

/** A remote call got no answer within its deadline. */
public final class DeadlineExceededException extends RemoteException implements ExecutionCertainty {

  private static final long serialVersionUID = 1L;

  private final boolean mayHaveRun;

  /**
   * @param call the called method, in words
   * @param deadline timeout of the call
   * @param mayHaveRun whether the server may have carried out the call
   */
  public DeadlineExceededException(String call, Duration deadline, boolean mayHaveRun) {
    super(
        call
            + " got no answer within "
            + deadline.toMillis()
            + " ms; "
            + (mayHaveRun
                ? "it may have run, so repeat it only if repeating does no harm"
                : "it has not run"));
    this.mayHaveRun = mayHaveRun;
  }

  /**
   * @param message the reason why the call was not tried
   */
  DeadlineExceededException(String message) {
    super(message);
    this.mayHaveRun = false;
  }

  @Override
  public boolean mayHaveRun() {
    return mayHaveRun;
  }
}
