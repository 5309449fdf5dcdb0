package org.dfra.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import org.dfra.app.log.PrintableTrace;
import org.dfra.app.plot.NoFontException;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ConsoleMessages;
import org.dfra.app.terminal.ExitCode;
import org.dfra.core.config.ConfigurationException;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.AdministrationRefusedException;
import org.dfra.module.NotReadyException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.ParseResult;

/** Reports a failure that the user can mend in its own sentence, and any other one in full. */
final class CommandExceptionHandler implements IExecutionExceptionHandler {

  @Override
  public int handleExecutionException(Exception e, CommandLine line, ParseResult parsed) {
    int code = code(e);
    PrintWriter err = line.getErr();
    if (code == ExitCode.SUCCESS) {
      err.print(PrintableTrace.of(e));
      err.flush();
      return line.getCommandSpec().exitCodeOnExecutionException();
    }
    String message = String.valueOf(e.getMessage());
    boolean isOfSeveralLines = e instanceof ConfigurationException;
    err.println(
        isOfSeveralLines
            ? ConsoleMessages.prefixedLines(message)
            : ConsoleMessages.prefixed(message));
    return code;
  }

  /** The status to end with; {@link ExitCode#SUCCESS} for what is nobody's to mend but ours. */
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
    return ExitCode.SUCCESS;
  }
}
