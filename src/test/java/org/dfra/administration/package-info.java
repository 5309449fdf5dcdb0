/** Tests of what administrators do to a robot while it runs, with real processes. */
package org.dfra.administration;
