package org.dfra.benchmarks.call;

import java.io.IOException;
import java.util.Locale;

/** What is measured of a peer. */
public enum CallKind {

  /** A call with a {@code long}, which is the answer too, by one thread. */
  SMALL("small call", 1) {
    @Override
    void call(Caller caller, long number) throws IOException {
      long answer = caller.echo(number);
      if (answer != number) {
        throw new IOException("the server answered " + answer + " instead of " + number);
      }
    }
  },

  /** A call that returns {@value EchoService#VALUES} doubles, by one thread. */
  VALUES(EchoService.VALUES + " doubles", 1) {
    @Override
    void call(Caller caller, long number) throws IOException {
      double[] answer = caller.values();
      if (!EchoServer.isExpected(answer)) {
        throw new IOException(
            "the server answered " + answer.length + " doubles that are not those it serves");
      }
    }
  },

  /** The small call, by many threads at once. */
  CALLERS("32 callers", 32) {
    @Override
    void call(Caller caller, long number) throws IOException {
      SMALL.call(caller, number);
    }
  };

  private final String label;
  private final int threads;

  CallKind(String label, int threads) {
    this.label = label;
    this.threads = threads;
  }

  /** Calls once and checks the answer. */
  abstract void call(Caller caller, long number) throws IOException;

  /** Its name in tables and records. */
  public String label() {
    return label;
  }

  /** How many threads call at once. */
  public int threads() {
    return threads;
  }

  /** Its name in the commands of the client's process. */
  String command() {
    return name().toLowerCase(Locale.ROOT);
  }

  static CallKind ofCommand(String command) {
    return valueOf(command.toUpperCase(Locale.ROOT));
  }
}
