package org.dfra.river.remote;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.module.Administrative;
import org.dfra.module.Diagnosis;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * Examinations that last longer than a call may: begun in one call, asked for in others. Proxies do
 * both.
 */
public interface RemoteDiagnostics extends Remote {

  /** What to run. */
  enum DiagnosticType {
    TEST,
    RECOVERY
  }

  /**
   * Begins a test or a recovery, which may interrupt the device for everybody.
   *
   * @return what to ask for it by
   * @throws IllegalArgumentException if none has this name
   */
  @Administrative
  UUID startDiagnostic(DiagnosticType sort, String name) throws RemoteException;

  /**
   * Waits for its end, {@link RemoteModule#MAX_CALL_WAIT} at the longest.
   *
   * @return what was found, or null while it runs
   * @throws IllegalArgumentException if there is no such run, because the module was activated anew
   *     or many others were begun since
   */
  @Idempotent
  @Nullable Diagnosis awaitDiagnosis(UUID run) throws RemoteException;
}
