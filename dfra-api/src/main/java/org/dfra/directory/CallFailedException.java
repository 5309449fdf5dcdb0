package org.dfra.directory;

import java.rmi.RemoteException;

/** A call through a proxy that stands for several modules failed and was not repeated. */
public final class CallFailedException extends RemoteException implements ExecutionCertainty {

  private static final long serialVersionUID = 1L;

  private final boolean mayHaveRun;

  /**
   * @param call the method and the module
   * @param mayHaveRun whether the module may have executed it
   */
  public CallFailedException(String call, boolean mayHaveRun, RemoteException cause) {
    super(
        call
            + " failed; "
            + (mayHaveRun
                ? "it may have run, so repeat it only if repeating does no harm"
                : "it has not run"),
        cause);
    this.mayHaveRun = mayHaveRun;
  }

  @Override
  public boolean mayHaveRun() {
    return mayHaveRun;
  }
}
