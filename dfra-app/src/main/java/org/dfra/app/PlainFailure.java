package org.dfra.app;

import java.io.IOException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import org.dfra.app.plot.NoFontException;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.core.config.ConfigurationException;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.AdministrationRefusedException;
import org.dfra.module.NotReadyException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.ParseResult;

/** Tells a failure that is the user's to mend in its own sentence, and any other one in full. */
final class PlainFailure implements IExecutionExceptionHandler {

  @Override
  public int handleExecutionException(Exception e, CommandLine line, ParseResult parsed)
      throws Exception {
    int code = code(e);
    if (code == ExitCode.WELL) {
      throw e;
    }
    line.getErr().println("dfra: " + e.getMessage());
    return code;
  }

  /** The status to end with; {@link ExitCode#WELL} for what is nobody's to mend but ours. */
  private static int code(Exception e) {
    if (e instanceof CommandFailure failure) {
      return failure.exitCode();
    } else if (e instanceof RemoteException) {
      return ExitCode.NO_ANSWER;
    } else if (e instanceof ConfigurationException
        || e instanceof IOException
        || e instanceof ActivationException
        || e instanceof NotReadyException
        || e instanceof AdministrationRefusedException
        || e instanceof LeaseRefusedException
        || e instanceof NoFontException
        || e instanceof IllegalArgumentException) { // what a module says of a wrong parameter
      return ExitCode.FAILED;
    }
    return ExitCode.WELL;
  }
}
