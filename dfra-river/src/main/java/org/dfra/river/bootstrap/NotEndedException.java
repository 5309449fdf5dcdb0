package org.dfra.river.bootstrap;

import java.rmi.activation.ActivationException;
import org.dfra.core.host.CommandName;
import org.jspecify.annotations.Nullable;

/** The end of a module is not confirmed: it may still have its device open. */
final class NotEndedException extends ActivationException {

  private static final long serialVersionUID = 1L;

  /**
   * @param why the reason, as a clause
   */
  NotEndedException(
      RegisteredGroup.RegisteredModule module, String why, @Nullable Throwable cause) {
    super(
        module.activation().module().path()
            + " may still work in group "
            + module.group()
            + ": "
            + why
            + "; end its process with "
            + CommandName.current()
            + " module kill "
            + module.activation().module().path()
            + " and try again");
    if (cause != null) {
      addSuppressed(cause); // as a cause, its message would be printed twice
    }
  }
}
