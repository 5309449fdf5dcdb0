package org.dfra.cli.security;

import java.io.Console;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;

/** Where commands get passphrases from: the first line of a file, or the terminal. */
public final class PassphraseSource {

  private static final int MAX_BYTES = 4096;

  private PassphraseSource() {}

  /**
   * The passphrase in a file, or one that is typed on the terminal.
   *
   * @param file null to ask on the terminal
   * @param subject of what, for the prompt
   * @param option that names the file, for the message
   * @throws CommandFailure if the file cannot be read or is empty, or there is no terminal
   */
  public static String read(@Nullable Path file, String subject, String option) {
    return file == null ? typed(subject, option) : ofFile(file);
  }

  /**
   * Asks twice for a new passphrase.
   *
   * @throws CommandFailure if both differ, or there is no terminal
   */
  public static String readNew(String subject, String option) {
    char[] first = typed("new passphrase of " + subject, option).toCharArray();
    char[] second = typed("the same again", option).toCharArray();
    boolean isEqual = Arrays.equals(first, second);
    if (!isEqual || first.length == 0) {
      throw new CommandFailure(
          ExitCode.FAILED,
          isEqual
              ? "an empty passphrase protects nothing; type another"
              : "the two differ; repeat");
    }
    return new String(first);
  }

  private static String typed(String subject, String option) {
    Console console = System.console();
    char[] typed = console == null ? null : console.readPassword("%s: ", subject);
    if (typed == null) {
      throw new CommandFailure(
          ExitCode.FAILED,
          "there is no terminal on which to ask for the "
              + subject
              + "; name a file with "
              + option);
    }
    return new String(typed);
  }

  private static String ofFile(Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      String text = new String(in.readNBytes(MAX_BYTES), StandardCharsets.UTF_8);
      String first = text.lines().findFirst().orElse("").strip();
      if (!first.isEmpty()) {
        return first;
      }
    } catch (NoSuchFileException e) {
      throw new CommandFailure(
          ExitCode.FAILED, "there is no file " + file + "; name the one with the passphrase", e);
    } catch (IOException e) {
      throw new CommandFailure(
          ExitCode.FAILED, "the passphrase in " + file + " cannot be read (" + e + ")", e);
    }
    throw new CommandFailure(
        ExitCode.FAILED, file + " is empty; its first line must be the passphrase");
  }
}
