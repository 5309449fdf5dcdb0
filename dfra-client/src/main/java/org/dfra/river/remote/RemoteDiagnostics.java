package org.dfra.river.remote;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.module.Administrative;
import org.dfra.module.Diagnosis;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * Diagnostics that last longer than a call may: one call starts them, others poll for the result.
 * Proxies do both.
 */
public interface RemoteDiagnostics extends Remote {

  /** The diagnostic to run. */
  enum DiagnosticType {
    TEST,
    RECOVERY
  }

  /**
   * Starts a test or a recovery, which may interrupt the device for all clients.
   *
   * @return the identifier of the run
   * @throws IllegalArgumentException if none has this name
   */
  @Administrative
  UUID startDiagnostic(DiagnosticType sort, String name) throws RemoteException;

  /**
   * Waits for the result, at most {@link RemoteModule#MAX_CALL_WAIT}.
   *
   * @return the result, or null while it runs
   * @throws IllegalArgumentException if there is no such run, because the module was activated
   *     again or many others were started since
   */
  @Idempotent
  @Nullable Diagnosis awaitDiagnosis(UUID run) throws RemoteException;
}
