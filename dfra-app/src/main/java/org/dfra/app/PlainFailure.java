package org.dfra.app;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import org.dfra.core.config.ConfigurationException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.ParseResult;

/** Tells a failure that is the user's to mend in its own sentence, and any other one in full. */
final class PlainFailure implements IExecutionExceptionHandler {

  @Override
  public int handleExecutionException(Exception e, CommandLine line, ParseResult parsed)
      throws Exception {
    if (e instanceof ConfigurationException
        || e instanceof IOException
        || e instanceof ActivationException) {
      line.getErr().println("dfra: " + e.getMessage());
      return line.getCommandSpec().exitCodeOnExecutionException();
    }
    throw e;
  }
}
