package org.dfra.text;

/**
 * Text that is safe to display. A name or a message of another computer may contain characters that
 * control a terminal, begin a new line, change the writing direction or are invisible. Each is
 * replaced by its escape as in Java and JSON: a backslash, the letter u and four hexadecimal
 * digits. A line feed becomes {@code
 * }, a carriage return {@code \r}, a tab {@code \t}. All other text is unchanged, except that every
 * kind of space becomes a plain one.
 *
 * <p>Escaped are control characters (C0, C1 and DEL), format characters (among them bidi overrides
 * and isolates, and zero-width characters), line and paragraph separators, lone surrogates,
 * private-use and unassigned characters, characters without a visible glyph, and combining marks
 * beyond {@value #MAX_MARKS} on one letter, which would cover the lines above and below. Letters of
 * right-to-left scripts are not escaped; a terminal may reorder them within their line.
 *
 * <p>The conversion is idempotent.
 */
public final class PrintableText {

  /** Maximum length of a word, in UTF-16 code units. */
  public static final int MAX_WORD_LENGTH = 200;

  /** Maximum length of a name, in UTF-16 code units. */
  public static final int MAX_NAME_LENGTH = 500;

  /** Maximum length of a line, in UTF-16 code units. */
  public static final int MAX_LINE_LENGTH = 16_384;

  /** Combining marks on one letter; languages need no more than these. */
  static final int MAX_MARKS = 4;

  private static final String MORE = "…";

  /** {@link java.rmi.RemoteException} begins a new line before its cause. */
  private static final String NESTED = "nested exception is: ";

  /** Extra capacity, since escapes are longer than the characters they replace. */
  private static final int ROOM = 64;

  private PrintableText() {}

  /**
   * A name without spaces, such as that of a module. Spaces are escaped too, since a name with
   * spaces could be read as a sentence.
   *
   * @return at most {@value #MAX_WORD_LENGTH} code units, and an ellipsis if there were more
   */
  public static String word(String text) {
    boolean isWord = text.indexOf(' ') < 0 && isPlain(text, MAX_WORD_LENGTH, "");
    return isWord ? text : line(text, MAX_WORD_LENGTH, true);
  }

  /**
   * A name, a title, or another short text, on one line.
   *
   * @return at most {@value #MAX_NAME_LENGTH} code units, and an ellipsis if there were more
   */
  public static String name(String text) {
    return line(text, MAX_NAME_LENGTH);
  }

  /**
   * A sentence, a message or another text, on one line.
   *
   * @return at most {@value #MAX_LINE_LENGTH} code units, and an ellipsis if there were more
   */
  public static String line(String text) {
    return line(text, MAX_LINE_LENGTH);
  }

  /**
   * A text of several lines that this program composed, such as the faults of a configuration. Line
   * ends are kept; each line is made printable.
   */
  public static String lines(String text) {
    String[] lines = text.replace("\r\n", "\n").replace(NESTED + "\n\t", NESTED).split("\n", -1);
    for (int i = 0; i < lines.length; i++) {
      lines[i] = line(lines[i], MAX_LINE_LENGTH);
    }
    return String.join("\n", lines);
  }

  /**
   * A whole JSON text with the same value. Non-printable characters in its strings are written as
   * JSON escapes; its own line ends and indentation are kept.
   *
   * @param json written by a generator that escapes control characters below U+0020 in strings
   */
  public static String json(String json) {
    return escapedBut(json, "\n\r");
  }

  /**
   * The output of a process, or a part of it. Line ends and tabs are kept, such as those of a stack
   * trace; nothing is truncated.
   */
  public static String output(String text) {
    return escapedBut(text, "\n\t");
  }

  private static String escapedBut(String text, String kept) {
    if (isPlain(text, Integer.MAX_VALUE, kept)) {
      return text;
    }
    StringBuilder safe = new StringBuilder(text.length() + ROOM);
    int at = 0;
    while (at < text.length()) {
      int c = text.codePointAt(at);
      if (kept.indexOf(c) >= 0 || !isHidden(c)) {
        safe.appendCodePoint(c);
      } else {
        appendUnits(safe, c);
      }
      at += Character.charCount(c);
    }
    return safe.toString();
  }

  /**
   * A text on one line.
   *
   * @param longest maximum number of UTF-16 code units that are kept; an ellipsis replaces the
   *     others
   */
  public static String line(String text, int longest) {
    return isPlain(text, longest, "") ? text : line(text, longest, false);
  }

  private static String line(String text, int longest, boolean isWord) {
    String whole = text.contains(NESTED) ? text.replace(NESTED + "\n\t", NESTED) : text;
    StringBuilder safe = new StringBuilder(Math.min(whole.length(), longest) + ROOM);
    int marks = 0;
    int at = 0;
    while (at < whole.length()) {
      int c = whole.codePointAt(at);
      marks = isMark(c) ? marks + 1 : 0;
      int before = safe.length();
      boolean isBlank = Character.getType(c) == Character.SPACE_SEPARATOR;
      if (isBlank && !isWord) {
        safe.append(' ');
      } else {
        append(safe, c, isBlank || marks > MAX_MARKS);
      }
      if (safe.length() > longest) {
        safe.setLength(before);
        return safe.append(MORE).toString();
      }
      at += Character.charCount(c);
    }
    return safe.toString();
  }

  private static void append(StringBuilder safe, int c, boolean isEscaped) {
    if (!isEscaped && !isHidden(c)) {
      safe.appendCodePoint(c);
    } else if (c == '\n') {
      safe.append("\\n");
    } else if (c == '\r') {
      safe.append("\\r");
    } else if (c == '\t') {
      safe.append("\\t");
    } else {
      appendUnits(safe, c);
    }
  }

  /** As in JSON and Java, a character beyond U+FFFF becomes both of its surrogates. */
  private static void appendUnits(StringBuilder safe, int c) {
    for (char unit : Character.toChars(c)) {
      safe.append("\\u");
      for (int shift = 12; shift >= 0; shift -= 4) {
        safe.append(Character.forDigit((unit >> shift) & 0xf, 16));
      }
    }
  }

  /** Nearly every text is plain, and is returned without a copy. */
  private static boolean isPlain(String text, int longest, String kept) {
    if (text.length() > longest) {
      return false;
    }
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      boolean isLatin = (c >= ' ' && c < 0x7f) || (c > 0xa0 && c < 0x300 && c != 0xad);
      if (!isLatin && kept.indexOf(c) < 0) {
        return false;
      }
    }
    return true;
  }

  private static boolean isMark(int c) {
    int type = Character.getType(c);
    return type == Character.NON_SPACING_MARK
        || type == Character.ENCLOSING_MARK
        || type == Character.COMBINING_SPACING_MARK;
  }

  /** Whether it is a control, format or other invisible character. */
  private static boolean isHidden(int c) {
    return switch (Character.getType(c)) {
      case Character.CONTROL,
          Character.FORMAT,
          Character.SURROGATE,
          Character.PRIVATE_USE,
          Character.UNASSIGNED,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR ->
          true;
      default -> isDrawnAsNothing(c);
    };
  }

  /** Letters, marks and symbols without a glyph: fillers, joiners and selectors of a variant. */
  private static boolean isDrawnAsNothing(int c) {
    return c == 0x034f
        || c == 0x115f
        || c == 0x1160
        || c == 0x17b4
        || c == 0x17b5
        || (c >= 0x180b && c <= 0x180f)
        || c == 0x2800
        || c == 0x3164
        || (c >= 0xfe00 && c <= 0xfe0f)
        || c == 0xffa0
        || (c >= 0xe0100 && c <= 0xe01ef);
  }
}
