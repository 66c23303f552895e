from .paper.laws.table import table_of_laws

__all__ = ["table_of_laws"]
