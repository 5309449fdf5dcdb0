package org.dfra.cli.audit;

import java.util.List;
import java.util.function.Function;
import org.dfra.report.terminal.TextWrap;

/**
 * Records as lines with aligned columns, one line for each record however long it is: so a search
 * in them finds whole records.
 *
 * @param who width of the callers, columns
 * @param what width of what happened, columns
 * @param decision width of the decisions, columns
 * @param rule width of the rules, columns
 */
record RecordColumns(int who, int what, int decision, int rule) {

  /** For records that come one by one. */
  static final RecordColumns USUAL = new RecordColumns(40, 44, 8, 20);

  private static final int WIDEST = 60;
  private static final int TIME = "2026-11-28T21:14:00.000Z".length();
  private static final String GAP = "  ";

  /** As wide as the widest of these records, within limits. */
  static RecordColumns of(List<RecordView> records) {
    return new RecordColumns(
        widest("WHO", records, RecordView::whoInWords),
        widest("WHAT", records, RecordView::whatInWords),
        widest("DECISION", records, RecordView::decision),
        widest("RULE", records, RecordView::rule));
  }

  private static int widest(
      String heading, List<RecordView> records, Function<RecordView, String> cell) {
    int widest =
        records.stream().map(cell).mapToInt(TextWrap::width).reduce(heading.length(), Math::max);
    return Math.min(WIDEST, widest);
  }

  String heading() {
    return line("TIME", "WHO", "WHAT", "DECISION", "RULE", "REASON");
  }

  String line(RecordView record) {
    return line(
        record.timeInWords(),
        record.whoInWords(),
        record.whatInWords(),
        record.decision(),
        record.rule(),
        record.reasonInWords());
  }

  private String line(
      String time, String caller, String event, String decided, String by, String reason) {
    return String.join(
            GAP,
            TextWrap.padded(time, TIME),
            TextWrap.padded(caller, who),
            TextWrap.padded(event, what),
            TextWrap.padded(decided, decision),
            TextWrap.padded(by, rule),
            reason)
        .stripTrailing();
  }
}
