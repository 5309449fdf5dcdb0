package org.dfra.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import org.dfra.cli.log.PrintableTrace;
import org.dfra.core.config.ConfigurationException;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.AdministrationRefusedException;
import org.dfra.module.NotReadyException;
import org.dfra.report.plot.NoFontException;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ConsoleMessages;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.IdentityException;
import org.dfra.security.AccessRefusedException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.ParseResult;

/**
 * Reports a failure that the user can correct in one sentence, and any other failure with its stack
 * trace.
 */
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

  /**
   * The exit status; {@link ExitCode#SUCCESS} for an internal error, which the user cannot correct.
   */
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
        || e instanceof AccessRefusedException
        || e instanceof LeaseRefusedException
        || e instanceof NoFontException
        || e instanceof IdentityException
        || e instanceof IllegalArgumentException) { // a module's message about an invalid parameter
      return ExitCode.FAILED;
    }
    return ExitCode.SUCCESS;
  }
}
